// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/leaf_mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "testbench/text_number.h"

namespace feline::mutation {
namespace {

// Instance below the one that is looked at, type, place in the sources, port.
using Identity = std::tuple<std::string, std::string, std::string, std::string>;

// Yosys ends the names of cells in numbers that rise while it reads a module.
std::uint64_t order(const Site& site) {
  const std::size_t end = site.cell.rfind('$');
  if (end == std::string::npos) return 0;
  return number_of<std::uint64_t>(std::string_view(site.cell).substr(end + 1)).value_or(0);
}

// The sites of an instance, those of one identity in the order of being read.
std::map<Identity, std::vector<const Site*>> sites_of(const std::vector<Site>& sites, const std::string& instance) {
  std::map<Identity, std::vector<const Site*>> of_instance;
  for (const Site& site : sites) {
    const std::string path = "." + instance_of(site.cell) + ".";
    const std::string begin = instance.empty() ? "." : "." + instance + ".";
    if (!path.starts_with(begin)) continue;
    of_instance[{path.substr(begin.size() - 1), site.type, site.source, site.port}].push_back(&site);
  }
  for (auto& [identity, alike] : of_instance)
    std::ranges::stable_sort(alike, {}, [](const Site* s) { return order(*s); });
  return of_instance;
}

// Instances that are in no other one than the top.
bool is_outermost(const std::string& path, const Elaboration& elaboration) {
  return !path.empty() && std::ranges::none_of(elaboration.instances, [&](const auto& other) {
    return !other.first.empty() && path.starts_with(other.first + ".");
  });
}

}  // namespace

LeafMutants::LeafMutants(const StageMutants& stage, std::string_view wrapper, const std::filesystem::path& source,
                         std::filesystem::path directory)
    : top_(fmt::format("feline_leaf_{}", wrapper)),
      source_(std::filesystem::absolute(source)),
      directory_(std::move(directory)) {
  const std::filesystem::path generated = source_ / "tables" / "generated";
  const std::filesystem::path leaves = source_ / "testbench" / "prove" / "rtl_leaves";
  elaboration_ = elaborate(top_,
                           fmt::format("{}; {}; {}; {}", read_command({generated / "feline_pkg.sv"}),
                                       read_command(sources_in(source_ / "rtl", "feline_")),
                                       read_command({leaves / "feline_stream_register.sv", leaves / (top_ + ".sv")}),
                                       read_command(sources_in(generated, "feline_rom_"), true)),
                           directory_);
  const std::vector<Site> own = instrument(elaboration_.netlist, top_, nullptr, true).sites;
  for (const auto& [path, module] : elaboration_.instances) {
    if (!is_outermost(path, elaboration_)) continue;
    const auto in_leaf = sites_of(own, path);
    for (const auto& [stage_path, stage_module] : stage.elaboration().instances) {
      if (stage_module != module) continue;
      for (const auto& [identity, alike] : sites_of(stage.sites(), stage_path)) {
        const auto found = in_leaf.find(identity);
        // Where the stage or the leaf needs fewer of them, it is not known which.
        if (found == in_leaf.end() || found->second.size() != alike.size()) continue;
        for (std::size_t i = 0; i < alike.size(); ++i) {
          if (found->second[i]->width == alike[i]->width) sites_.emplace(alike[i]->number, found->second[i]->number);
        }
      }
    }
  }
}

std::optional<Mutant> LeafMutants::in_leaf(const Mutant& mutant) const {
  const auto site = sites_.find(mutant.site);
  if (mutant.kind == Kind::kRomBit || site == sites_.end()) return std::nullopt;
  Mutant own = mutant;
  own.site = site->second;
  return own;
}

Aiger LeafMutants::logic(const std::vector<Mutant>& mutants) const {
  std::set<std::uint32_t> numbers;
  for (const Mutant& mutant : mutants) numbers.insert(mutant.site);
  const std::vector<std::uint32_t> only(numbers.begin(), numbers.end());
  const InstrumentedStage instrumented = instrument(elaboration_.netlist, top_, &only, true);
  std::vector<std::filesystem::path> sources{source_ / "testbench" / "mutation" / "feline_mutation_site.sv"};
  for (const std::string& rom : instrumented.roms) {
    sources.push_back(source_ / "tables" / "generated" / fmt::format("feline_rom_{}.sv", rom));
  }
  return read_aiger(to_gates(instrumented.netlist, top_, read_command(sources), directory_));
}

}  // namespace feline::mutation
