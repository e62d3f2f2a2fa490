// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "testbench/random.h"
#include "testbench/stability/subjects.h"

namespace feline::stability {

// A kind of stiff or extreme input.
struct CaseClass {
  std::string_view name;
  std::string_view description;
  Case (*draw)(SplitMix64&);  // finite lookups only
};
std::span<const CaseClass> case_classes();

// `count` cases of a class; the same for the same seed, whichever other classes run.
std::vector<Case> draw_cases(const CaseClass& of, std::uint64_t count, std::uint64_t seed);

// Gradients in texels of the first test texture, 256 x 256, whose components are at most 2^24 in magnitude and of an
// exact condition number near `condition`, 1 .. 1e13: the condition as generated, before any rounding.
reference::Gradients<double> stiff_gradients(SplitMix64& random, double condition);

}  // namespace feline::stability
