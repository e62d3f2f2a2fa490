// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/bounds.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "testbench/stability/ratio_bounds.h"

namespace feline::stability {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Rounding four mantissas by at most half of one, the largest at least 64, turns the axis by at most 2 |change|/major,
// weighted; a length 1.2 % off can take the next row, or the other of two vectors of nearly equal length for the
// longer.
constexpr double kMantissaAxis = 2 * 1.0 / 64;
constexpr double kLengthAxis = 0.04;
// The two-part length against the true one.
constexpr double kLengthLow = 1 - 0.01116;
constexpr double kLengthHigh = 1 + 0.01213;
// Level: the radius' own rounding, its 9 significant bits and the logarithm's rounding, as in
// tests/support/monotonic.h.
constexpr double kLevelRounding = 0.0063 + 0.0029 + 0.002;
// Widening to the probes: 2 major/(N + 1) is at most 5/4 of the minor radius, at N = 1.
constexpr double kMostWidened = 1.25;

struct UnitRatios {
  double major_low, major_high, effective_low, effective_high, axis;
};
UnitRatios ratios(bool table) {
  if (table) {
    return {kTableRatios.major_low, kTableRatios.major_high, kTableRatios.effective_low, kTableRatios.effective_high,
            kTableAxis + kMantissaAxis + kLengthAxis};
  }
  return {kSimpleRatios.major_low * kSimpleMajorLow * kLengthLow, kSimpleRatios.major_high * kLengthHigh,
          kSimpleRatios.effective_low * kSimpleMajorLow * kLengthLow,
          kSimpleRatios.effective_high * kSimpleEffectiveHigh * kLengthHigh, kSimpleAxis + kMantissaAxis + kLengthAxis};
}

double off_one(double low, double high) { return std::max(1 - low, high - 1); }

double unit_bound(bool table, Metric metric, const Facts& facts) {
  const UnitRatios r = ratios(table);
  const LevelRange range = unit_level_range(table);
  const double level = std::max(-range.low, range.high);
  switch (metric) {
    case Metric::kMajor: return off_one(r.major_low, r.major_high);
    case Metric::kMinor: return kNone;
    case Metric::kEffective: return off_one(r.effective_low, r.effective_high);
    case Metric::kAxis: return r.axis;
    case Metric::kRawLevel:
    case Metric::kLevel: return level;
    case Metric::kColour: {
      const LevelSlope& slope = facts.texture->slope_from(static_cast<int>(std::floor(facts.level + range.low)));
      // The unit's line is at most as long as its major radius; a radius below 5/4 makes one probe.
      const double most = r.major_high * kLengthHigh * facts.major;
      const double reach_s = most < kMostWidened ? 0 : most / facts.texture->width();
      const double reach_t = most < kMostWidened ? 0 : most / facts.texture->height();
      const double along = slope.s * (facts.reach_s + reach_s) + slope.t * (facts.reach_t + reach_t);
      return std::min(slope.range + 1, slope.to_next * level + along + 1);
    }
  }
  return kNone;
}

// Relative error of the radii by the printed formulas, to first order; no promise where it nears 1.
double printed_radius(double unit, const Facts& facts) {
  const double error = 16 * unit * facts.condition * facts.condition;
  if (error > 0.125) return kNone;
  return error;
}

struct FormulaErrors {
  double major, minor, axis, level;
};

FormulaErrors formula_errors(Subject subject, const Facts& facts) {
  const bool single = is_float32(subject);
  const double unit = single ? 0x1p-24 : 0x1p-53;
  const double levels = 2 * unit * std::abs(facts.raw_level);
  if (is_printed(subject)) {
    if (facts.major == 0 || (single && !facts.ordinary_range)) return {kNone, kNone, kNone, kNone};
    const double radius = printed_radius(unit, facts);
    return {radius, radius, radius == kNone ? kNone : 40 * unit, 2 * radius + levels + 40 * unit};
  }
  // A float32 gradient times a size that is no power of two is rounded: a change of the matrix, which the determinant
  // feels in proportion to the condition number. Products below the least denormal are lost.
  const bool rounded = single && !facts.exact_in_texels;
  const double least = single ? 0x1p-146 : 0x1p-1070;
  const double lost = std::isfinite(facts.condition) ? least * facts.condition : 0;
  return {6 * unit, 8 * unit + (rounded ? 2 * unit * facts.condition : 0) + lost, 20 * unit, 40 * unit + levels};
}

double formula_bound(Subject subject, Metric metric, const Facts& facts) {
  const FormulaErrors errors = formula_errors(subject, facts);
  switch (metric) {
    case Metric::kMajor: return errors.major;
    case Metric::kMinor: return errors.minor;
    // Where the condition number exceeds 17/2 the major radius decides.
    case Metric::kEffective:
      return is_printed(subject) ? errors.major : 8 * (is_float32(subject) ? 0x1p-24 : 0x1p-53) * 3;
    case Metric::kAxis: return errors.axis;
    case Metric::kRawLevel:
    case Metric::kLevel: return errors.level;
    case Metric::kColour: {
      if (errors.level == kNone) return kNone;
      const double unit = is_float32(subject) ? 0x1p-24 : 0x1p-53;
      const LevelSlope& slope = facts.texture->slope_from(static_cast<int>(std::floor(facts.level - errors.level)));
      const double line = 128 * unit + 2 * errors.level;  // of the line's half, relative
      const double s = slope.s * (4 * unit * (facts.distance + 1 + facts.reach_s) + line * facts.reach_s);
      const double t = slope.t * (4 * unit * (facts.distance + 1 + facts.reach_t) + line * facts.reach_t);
      return std::min(slope.range, slope.to_next * errors.level + s + t) + 255 * 128 * unit;
    }
  }
  return kNone;
}

}  // namespace

Facts facts_of(const Case& of, const Truth& truth) {
  const TestTexture& texture = texture_of(of);
  Facts facts;
  facts.condition = truth.ellipse.condition();
  facts.raw_level = truth.line.level.to_double();
  if (!std::isfinite(facts.raw_level)) facts.raw_level = 0;  // of two zero gradients
  facts.level = truth.level.to_double();
  facts.major = truth.ellipse.major_radius.to_double();
  facts.distance = std::abs(static_cast<double>(of.lookup.s)) + std::abs(static_cast<double>(of.lookup.t));
  const double steps = (truth.line.probes - 1) / 2.0;
  facts.reach_s = steps * std::abs(truth.line.step.u.to_double()) / texture.width();
  facts.reach_t = steps * std::abs(truth.line.step.v.to_double()) / texture.height();
  facts.exact_in_texels = texture.exact_in_texels();
  facts.ordinary_range = facts.major > 0x1p-24 && facts.major < 0x1p24;
  facts.texture = &texture;
  return facts;
}

double bound(Subject subject, Metric metric, const Facts& facts, double tighten) {
  if (is_unit(subject)) return unit_bound(subject == Subject::kUnitTable, metric, facts) / tighten;
  return formula_bound(subject, metric, facts) / tighten;
}

LevelRange unit_level_range(bool table) {
  const UnitRatios r = ratios(table);
  const double low = std::min(r.major_low, r.effective_low);
  const double high = std::max(r.major_high, r.effective_high);
  return {std::log2(low / kMostWidened) - kLevelRounding, std::log2(high * kMostWidened) + kLevelRounding};
}

double unit_jump_bound(bool table) {
  const RatioBounds& r = table ? kTableRatios : kSimpleRatios;
  return std::log2(r.high() / r.low() * kMostWidened) + 2 * kLevelRounding;
}

BoundText bound_text(Subject subject, Metric metric) {
  if (is_unit(subject)) {
    const bool table = subject == Subject::kUnitTable;
    const UnitRatios r = ratios(table);
    const LevelRange range = unit_level_range(table);
    const std::string over = table ? "the ideal ellipse" : "Simple's own radii";
    switch (metric) {
      case Metric::kMajor:
        return {fmt::format("{:.4f} to {:.4f} of the true one", r.major_low, r.major_high),
                table
                    ? "enumerated over all mantissas against the ideal ellipse (tests/model/footprint_bounds_test.cpp)"
                    : "the longer gradient is 1/sqrt(2) to 1 of the major radius; the two-part length is -1.12 % to "
                      "+1.21 % off; mantissas are rounded by up to 1/128"};
      case Metric::kMinor: return {};
      case Metric::kEffective:
        return {fmt::format("{:.4f} to {:.4f} of the true one", r.effective_low, r.effective_high),
                table ? "enumerated over all mantissas (the same test)"
                      : "enumerated over all mantissas against Simple's own radii, times Simple's own error: the "
                        "shortest side or diagonal is up to 3.96 effective radii"};
      case Metric::kAxis:
        return {fmt::format("{:.3f}", r.axis),
                fmt::format("{} {:.3f}, mantissas rounded to nearest {:.4f}, the two-part length {:.2f}",
                            table ? "within a table cell" : "the longer gradient against the axis",
                            table ? kTableAxis : kSimpleAxis, kMantissaAxis, kLengthAxis)};
      case Metric::kRawLevel:
      case Metric::kLevel:
        return {fmt::format("{:.3f} to +{:.3f} octaves", range.low, range.high),
                fmt::format("the effective radius' bounds, a line widened by up to 5/4 on either side, 0.0112 for "
                            "roundings of radius and logarithm (against {}: tests/support/monotonic.h)",
                            over)};
      case Metric::kColour:
        return {"level steps x level bound + slope x (both lines) + 1, at most the levels' range",
                "a colour is a mean of texels no farther away than half the line; slopes and steps are the texture's; "
                "1 code for sub-texel positions of 1/256 and the result's rounding"};
    }
  }
  if (is_printed(subject)) {
    const std::string where = "where that is at most 1/8, beyond nothing is promised";
    switch (metric) {
      case Metric::kMajor:
      case Metric::kMinor:
      case Metric::kEffective:
        return {"16 u k^2, " + where,
                "F = A C - B^2/4 cancels from major^4 to major^2 minor^2, and A + C - root from 1/minor^2 to "
                "1/major^2: each costs the square of the condition number k; u is 2^-24 or 2^-53. float32: only within "
                "2^-24 to 2^24 texels, as F is a fourth power"};
      case Metric::kAxis:
        return {"40 u, where the radii are promised",
                "F's error scales A, B and C alike; C - A cancels as the axis' weight says"};
      case Metric::kRawLevel:
      case Metric::kLevel:
        return {"32 u k^2 + 40 u + 2 u |level|, where the radii are promised", "the radii's, through the logarithm"};
      case Metric::kColour:
        return {"level steps x level bound + slope x error of the line + 255 x 128 u", "as for the stable formulas"};
    }
  }
  switch (metric) {
    case Metric::kMajor:
      return {"6 u", "two hypotenuses of sums that are each rounded once, and their sum; none cancels"};
    case Metric::kMinor:
      return {
          "8 u; in float32 8 u + 2 u k where the size is no power of two",
          "Kahan's determinant (2 u) over the major radius; a gradient rounded on its way to texels is another "
          "matrix, whose determinant moves with the condition number k. Products below the least denormal are lost"};
    case Metric::kEffective: return {"24 u", "the minor radius counts only where k is below 17/2"};
    case Metric::kAxis: return {"20 u", "half a sum of two arctangents, each rounded once, of sums rounded once"};
    case Metric::kRawLevel:
    case Metric::kLevel: return {"40 u + 2 u |level|", "24 u / ln 2, and the logarithm's own rounding"};
    case Metric::kColour:
      return {"level steps x level bound + slope x (4 u x distance from the origin + error of the line) + 255 x 128 u",
              "a coordinate is rounded to its own last bit when a step is added; slopes and steps are the texture's"};
  }
  return {};
}

}  // namespace feline::stability
