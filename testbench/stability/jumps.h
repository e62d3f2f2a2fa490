// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "testbench/stability/subjects.h"

namespace feline::stability {

// Lookups in which one float32 derivative takes every value from one number to another, ulp by ulp.
struct Path {
  std::string_view name;
  std::string_view description;
  Case start;
  float Lookup::*derivative = &Lookup::dsdx;
  float last = 0;  // above start's value; both positive

  Case at(float value) const;
};
// One for each boundary that Feline or the unit has, and `random_count` of tame lookups.
std::vector<Path> paths(std::uint64_t random_count, std::uint64_t seed);

// Where a jump comes from: the first that applies.
enum class Cause {
  kLongerVector,  // the other gradient becomes the longer one
  kTableCell,     // another entry of the ellipse table
  kProbeCount,    // fProbes rounds to another count, or the level passes that of 1 x 1
  kExponent,      // another exponent of group scaling
  kMantissa,      // another 8-bit mantissa
  kRounding,      // of a formula: fProbes rounds to another count where Feline's boundary is out of its bound's reach
  kOther,
};
inline constexpr std::array<std::string_view, 7> kCauseNames{
    "longer vector", "table cell", "probe count", "group exponent", "mantissa", "rounding", "other"};

// A change between two lookups whose derivative differs by one ulp.
struct Jump {
  std::string_view path;        // its name
  Case at;                      // before the jump
  float before = 0, after = 0;  // the derivative
  Cause cause = Cause::kOther;
  int probes_before = 0, probes_after = 0;
  double level = 0;        // octaves, after less before
  double colour = 0;       // codes, after less before
  double exact_level = 0;  // of Feline at 200 bits over the same ulp
  // Of a formula: how far from the two lookups the truth's own boundary lies, over how far the radii's bound lets it
  // be; at most 1 means that Feline itself jumps here. Infinite where nothing is promised.
  double share = 0;
};

// Every change of a discrete decision on the path: probe count; for the unit also mantissas and exponent, which decide
// everything else. No subject is the truth itself.
std::vector<Jump> find_jumps(std::optional<Subject> subject, const Path& path);

}  // namespace feline::stability
