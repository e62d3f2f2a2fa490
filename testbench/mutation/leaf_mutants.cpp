// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/leaf_mutants.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "testbench/mutation/same_sites.h"

namespace feline::mutation {
namespace {

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
  own_ = instrument(elaboration_.netlist, top_, nullptr, true).sites;
  for (const auto& [path, module] : elaboration_.instances) {
    if (!is_outermost(path, elaboration_)) continue;
    bool is_there = false;
    for (const auto& [stage_path, stage_module] : stage.elaboration().instances) {
      if (stage_module != module) continue;
      is_there = true;
      sites_.merge(same_sites(stage.sites(), stage_path, own_, path));
    }
    // With other parameters the name is another one.
    if (!is_there) throw std::runtime_error(fmt::format("{}: {} has no {}", top_, stage.stage(), module));
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
  const std::vector<std::uint32_t> only = site_numbers(mutants);
  const InstrumentedStage instrumented = instrument(elaboration_.netlist, top_, &only, true);
  std::vector<std::filesystem::path> sources{source_ / "testbench" / "mutation" / "feline_mutation_site.sv"};
  for (const std::string& rom : instrumented.roms) {
    sources.push_back(source_ / "tables" / "generated" / fmt::format("feline_rom_{}.sv", rom));
  }
  return read_aiger(to_gates(instrumented.netlist, top_, read_command(sources), directory_));
}

}  // namespace feline::mutation
