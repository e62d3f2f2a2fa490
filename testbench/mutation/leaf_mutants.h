// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/mutation/aiger.h"
#include "testbench/mutation/stage_mutants.h"

namespace feline::mutation {

// A stage's mutants in a leaf of `feline prove`, whose RTL is a part of the stage: the same cell, written in the same
// place, in an instance of the same module under the same parameters.
class LeafMutants {
 public:
  // Runs Yosys on feline_leaf_WRAPPER; writes files to `directory`.
  LeafMutants(const StageMutants& stage, std::string_view wrapper, const std::filesystem::path& source,
              std::filesystem::path directory);

  // The leaf's own, or nothing: it is not in the leaf, or is the bit of a ROM.
  std::optional<Mutant> in_leaf(const Mutant& mutant) const;

  // The instance that a mutant of the leaf is in, as "u_length.u_quotient".
  std::string instance(const Mutant& own) const { return instance_of(own_[own.site - 1].cell); }

  // Gates, with the mutant as inputs mutant[0] to mutant[63], of these mutants of the leaf.
  Aiger logic(const std::vector<Mutant>& mutants) const;

 private:
  std::string top_;
  std::filesystem::path source_, directory_;
  Elaboration elaboration_;
  std::vector<Site> own_;
  std::map<std::uint32_t, std::uint32_t> sites_;  // the leaf's, by the stage's
};

}  // namespace feline::mutation
