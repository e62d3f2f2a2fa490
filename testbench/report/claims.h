// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/measure/survey.h"

namespace feline {

enum class Verdict : std::uint8_t { kHolds, kContradicted, kNotMeasured };

// A sentence of a paper, or a bound of this project, and what was measured of it.
struct Claim {
  std::string name;
  std::string statement;
  std::string source;
  bool ours = false;  // a bound of this project: the report fails when it is broken
  Verdict verdict = Verdict::kNotMeasured;
  std::vector<std::string> measured{};  // a line each
  // Of the scenes that the statement speaks of, those that were judged.
  std::size_t scenes = 0;
  std::size_t wanted_scenes = 0;
  std::string reason{};  // where the measurement contradicts the statement
};

std::vector<Claim> judge_claims(const Survey& survey);

// "holds", "contradicted, 1 of 7 scenes", ...
std::string verdict_text(const Claim& claim);

// How far the 8-bit unit falls behind Table Feline in double, decibels against either truth. Judged where a
// picture's sides are at least kLeastJudgedSide pixels: of less there is too little to see a quarter of a decibel in.
inline constexpr double kUnitBound = 0.25;
inline constexpr int kLeastJudgedSide = 256;
enum class UnitVerdict : std::uint8_t { kHolds, kBroken, kNotJudged };
UnitVerdict judge_unit(const ExhibitPlan& plan, const Cell& real, const Cell& unit);

}  // namespace feline
