// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "testbench/stability/subjects.h"

namespace feline::stability {

// What is compared with the truth.
enum class Metric {
  kMajor,      // relative
  kMinor,      // relative
  kEffective,  // relative, of max(minor, 2/17 major), the least radius that 16 probes leave: it sets the level
  kAxis,       // radians times 1 - (minor/major)^2
  kRawLevel,   // octaves, before the clamps, within -32 .. 31.996 as the unit has it
  kLevel,      // octaves, within the texture's levels
  kColour,     // codes, 1/255
};
inline constexpr std::array kMetrics{Metric::kMajor,    Metric::kMinor, Metric::kEffective, Metric::kAxis,
                                     Metric::kRawLevel, Metric::kLevel, Metric::kColour};
inline constexpr std::array<std::string_view, kMetrics.size()> kMetricNames{
    "major radius", "minor radius", "effective radius", "axis", "level, unclamped", "level", "colour"};
inline constexpr std::array<std::string_view, kMetrics.size()> kMetricKeys{"major",     "minor", "effective", "axis",
                                                                           "raw_level", "level", "colour"};
inline constexpr std::array<std::string_view, kMetrics.size()> kMetricUnits{
    "relative", "relative", "relative", "rad x (1 - (minor/major)^2)", "octave", "octave", "code, 1/255"};

// What a bound depends on: the case's truth, never what a subject made of it.
struct Facts {
  double condition = 1;
  double raw_level = 0;
  double level = 0;
  double major = 0;             // texels
  double distance = 0;          // |s| + |t|, textures
  double reach_s = 0;           // half the line of probes, textures
  double reach_t = 0;           // the same along t
  bool exact_in_texels = true;  // the gradients are float32 numbers in texels, too
  bool ordinary_range = true;   // and squares of squares of them stay far from float32's limits
  const TestTexture* texture = nullptr;
};
Facts facts_of(const Case& of, const Truth& truth);

// The unit's numbers are those of the configuration that is checked in.
//
// The most that the subject may be off; infinite where nothing is promised. `tighten` divides every bound: above 1 for
// tests of what a broken bound does.
double bound(Subject subject, Metric metric, const Facts& facts, double tighten = 1);

// Simple's formulas, exactly evaluated, against the ideal ellipse: the longer gradient is at least 1/sqrt(2) of the
// major radius, the shortest of sides and diagonals at least the minor one; the largest ratio of effective radii,
// difference of minor radii to the major one and weighted turn are of gradients x = (1, 0), |y| <= 1, rounded up from
// a lattice (tests/testbench/stability_test.cpp).
inline constexpr double kSimpleMajorLow = 0.70710678;
inline constexpr double kSimpleEffectiveHigh = 3.96;
inline constexpr double kSimpleAxis = 0.338;
// Weighted turn between a cell's entry and its ellipses (the same test).
inline constexpr double kTableAxis = 0.0598;

// The bound as a formula, and why it is that; "" where there is none.
struct BoundText {
  std::string formula;
  std::string reason;
};
BoundText bound_text(Subject subject, Metric metric);

// How far the level can be off either way, in octaves.
struct LevelRange {
  double low;
  double high;
};
LevelRange unit_level_range(bool table);

// The most by which the unit's level can jump between lookups that are an ulp apart, octaves.
double unit_jump_bound(bool table);

}  // namespace feline::stability
