// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "testbench/stability/subjects.h"

namespace feline::stability {

// What comes out where NaN, infinity or the ends of float32 go in.
struct NonFiniteRow {
  std::string_view what;  // the value, and in which operands
  std::uint64_t count = 0;
  struct Result {
    std::uint64_t colour_defined = 0;  // a number within the texture's lowest and highest texel
    std::uint64_t level_defined = 0;   // within the texture's levels
    std::uint64_t coarsest = 0;        // of these the last level
    std::uint64_t flagged = 0;         // the unit: the status bits that its contract names, no other
  };
  std::array<Result, kSubjects.size()> results{};

  // Of the unit: all of them defined and flagged. Formulas promise nothing here.
  bool holds(Subject subject) const;
};

// Each value in each single operand, in each pair and in all of its kind, in 16 tame lookups.
std::vector<NonFiniteRow> run_non_finite(std::uint64_t seed);

}  // namespace feline::stability
