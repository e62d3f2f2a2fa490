// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/mutant.h"

#include <algorithm>
#include <map>
#include <set>

#include "testbench/random.h"

namespace feline::mutation {
namespace {

std::size_t count_mutants(const Site& site) {
  std::size_t count = 0;
  for (const Site::Bit& bit : site.bits) count += bit.constant ? 1 : 3 + 2 * (site.width - 1);
  return count;
}

Mutant draw(const Site& site, SplitMix64& random) {
  const Site::Bit bit = site.bits[random.below(static_cast<std::uint32_t>(site.bits.size()))];
  Mutant mutant{site.number, Kind::kInvert, bit.place, 0};
  if (bit.constant) return mutant;
  mutant.kind = static_cast<Kind>(random.below(site.width > 1 ? 5 : 3));
  if (mutant.kind >= Kind::kInvertWhenZero) {
    mutant.control = (bit.place + 1 + random.below(site.width - 1)) % site.width;
  }
  return mutant;
}

bool insert(std::map<std::uint64_t, Mutant>& drawn, const Mutant& mutant) {
  return drawn.emplace(code(mutant), mutant).second;
}

}  // namespace

std::uint64_t code(const Mutant& mutant) {
  return mutant.site | static_cast<std::uint64_t>(mutant.kind) << 16 | std::uint64_t{mutant.bit} << 20 |
         std::uint64_t{mutant.control} << 32;
}

std::vector<Mutant> site_mutants(const Site& site) {
  std::vector<Mutant> mutants;
  for (const Site::Bit& bit : site.bits) {
    mutants.push_back({site.number, Kind::kInvert, bit.place, 0});
    if (bit.constant) continue;
    mutants.push_back({site.number, Kind::kZero, bit.place, 0});
    mutants.push_back({site.number, Kind::kOne, bit.place, 0});
    for (std::uint32_t control = 0; control < site.width; ++control) {
      if (control == bit.place) continue;
      mutants.push_back({site.number, Kind::kInvertWhenZero, bit.place, control});
      mutants.push_back({site.number, Kind::kInvertWhenOne, bit.place, control});
    }
  }
  return mutants;
}

std::vector<std::uint32_t> site_numbers(const std::vector<Mutant>& mutants) {
  std::set<std::uint32_t> numbers;
  for (const Mutant& mutant : mutants) numbers.insert(mutant.site);
  return {numbers.begin(), numbers.end()};
}

std::vector<Mutant> draw_mutants(const std::vector<Site>& sites, std::size_t count, std::uint64_t seed) {
  std::size_t all = 0;
  std::vector<const Site*> open;
  for (const Site& site : sites) {
    all += count_mutants(site);
    if (!site.bits.empty()) open.push_back(&site);
  }
  count = std::min(count, all);
  SplitMix64 random(seed);
  std::map<std::uint64_t, Mutant> drawn;  // by code
  std::vector<std::size_t> left;
  for (const Site* const site : open) left.push_back(count_mutants(*site));
  while (drawn.size() < count) {
    const std::size_t place = random.below(static_cast<std::uint32_t>(open.size()));
    if (!insert(drawn, draw(*open[place], random)) || --left[place] != 0) continue;
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(place));
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(place));
  }
  std::vector<Mutant> mutants;
  for (const auto& [number, mutant] : drawn) mutants.push_back(mutant);
  return mutants;
}

std::vector<Mutant> rom_mutants(const std::vector<Rom>& roms) {
  std::vector<Mutant> mutants;
  for (std::uint32_t rom = 0; rom < roms.size(); ++rom) {
    for (std::uint32_t word = 0; word < roms[rom].words; ++word) {
      for (std::uint32_t bit = 0; bit < roms[rom].width; ++bit) mutants.push_back({rom + 1, Kind::kRomBit, bit, word});
    }
  }
  return mutants;
}

}  // namespace feline::mutation
