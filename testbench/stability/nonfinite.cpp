// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/nonfinite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "testbench/stability/cases.h"

namespace feline::stability {
namespace {

using Operand = float Lookup::*;
constexpr std::array<Operand, 2> kCoordinates{&Lookup::s, &Lookup::t};
constexpr std::array<Operand, 4> kDerivatives{&Lookup::dsdx, &Lookup::dtdx, &Lookup::dsdy, &Lookup::dtdy};

// By the contract of model/group.h; the tests' samplers repeat, so no finite coordinate saturates.
std::int64_t wanted_status(const Case& of) {
  const auto not_finite = [&](Operand operand) { return !std::isfinite(of.lookup.*operand); };
  std::int64_t status = std::ranges::any_of(kCoordinates, not_finite) ? kCoordinateNotFinite : 0;
  if (std::ranges::any_of(kDerivatives, not_finite)) return status | kDerivativeNotFinite;
  const double width = texture_of(of).width();
  const double height = texture_of(of).height();
  const Lookup& at = of.lookup;
  const double most = std::max(
      {std::abs(at.dsdx * width), std::abs(at.dsdy * width), std::abs(at.dtdx * height), std::abs(at.dtdy * height)});
  // Feline's modes round to the nearest mantissa, of which 127 * 2^63 texels is the largest.
  return most >= 127.5 * 0x1p63 ? status | kOverflow : status;
}

void judge(NonFiniteRow& row, const Case& of) {
  ++row.count;
  const Texture& texture = texture_of(of).texture();
  const auto [least, most] = std::ranges::minmax(texture.levels.front().texels);
  for (const Subject subject : kSubjects) {
    const Outcome outcome = evaluate(subject, of);
    NonFiniteRow::Result& result = row.results[static_cast<std::size_t>(subject)];
    if (outcome.colour >= least && outcome.colour <= most) ++result.colour_defined;
    if (outcome.level >= 0 && outcome.level <= texture_of(of).last_level()) ++result.level_defined;
    if (outcome.level == texture_of(of).last_level()) ++result.coarsest;
    if (is_unit(subject) && outcome.status == wanted_status(of)) ++result.flagged;
  }
}

NonFiniteRow run_row(std::string_view what, float special, std::span<const Operand> operands,
                     const std::vector<Case>& bases) {
  NonFiniteRow row{what};
  for (const Case& base : bases) {
    Case all = base;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      for (std::size_t j = i; j < operands.size(); ++j) {
        Case of = base;
        of.lookup.*operands[i] = special;
        of.lookup.*operands[j] = i == j ? special : -special;
        judge(row, of);
      }
      all.lookup.*operands[i] = special;
    }
    judge(row, all);
  }
  return row;
}

}  // namespace

bool NonFiniteRow::holds(Subject subject) const {
  const Result& result = results[static_cast<std::size_t>(subject)];
  if (!is_unit(subject)) return true;
  return result.colour_defined == count && result.level_defined == count && result.flagged == count;
}

std::vector<NonFiniteRow> run_non_finite(std::uint64_t seed) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kGreatest = std::numeric_limits<float>::max();
  constexpr float kLeast = std::numeric_limits<float>::denorm_min();
  const std::vector<Case> bases = draw_cases(case_classes().front(), 16, seed);
  return {
      run_row("NaN derivatives", kNaN, kDerivatives, bases),
      run_row("infinite derivatives", kInfinity, kDerivatives, bases),
      run_row("greatest float32 derivatives", kGreatest, kDerivatives, bases),
      run_row("least denormal derivatives", kLeast, kDerivatives, bases),
      run_row("NaN coordinates", kNaN, kCoordinates, bases),
      run_row("infinite coordinates", kInfinity, kCoordinates, bases),
      run_row("greatest float32 coordinates", kGreatest, kCoordinates, bases),
  };
}

}  // namespace feline::stability
