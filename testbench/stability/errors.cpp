// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/errors.h"

#include <cmath>
#include <limits>

namespace feline::stability {
namespace {

constexpr double kLost = std::numeric_limits<double>::infinity();
constexpr double kLeastUnitRadius = 0x1p-57;  // texels

double relative(double got, const Real& want, double forgiven) {
  if (!std::isfinite(got)) return kLost;
  const Real difference = abs(Real(got) - want) - Real(forgiven);
  if (!(difference > Real(0))) return 0;
  return want > Real(0) ? (difference / want).to_double() : kLost;
}

double absolute(double got, const Real& want) { return std::isfinite(got) ? abs(Real(got) - want).to_double() : kLost; }

// The larger of the minor radius and 2/17 of the major one.
double effective(double major, double minor) { return std::max(minor, 2 * major / (kMaxProbes + 1)); }
Real effective(const ExactEllipse& ellipse) {
  const Real least = Real(2) * ellipse.major_radius / Real(kMaxProbes + 1);
  return ellipse.minor_radius < least ? least : ellipse.minor_radius;
}

double axis_error(const Outcome& outcome, const ExactEllipse& ellipse) {
  const bool none = outcome.axis_u == 0 && outcome.axis_v == 0;
  if (none || !std::isfinite(outcome.axis_u) || !std::isfinite(outcome.axis_v)) return kLost;
  // An axis has no direction: half a turn is no error.
  const Real turn = sin(atan2(Real(outcome.axis_v), Real(outcome.axis_u)) - ellipse.angle);
  return (abs(turn) * ellipse.axis_weight()).to_double();
}

// Into the unit's format, S5.8; NaN stays NaN.
double saturated(double level) {
  const auto format = Formats<kDefaultConfig>::kLevelOfDetail;
  const double low = format.value(format.min_raw());
  const double high = format.value(format.max_raw());
  return level < low ? low : level > high ? high : level;
}

// Whether the radii's bound allows a count on the other side of the boundary between it and the truth's.
bool near_boundary(Subject subject, const Facts& facts, const Line<Real>& truth, int probes) {
  const double radii = bound(subject, Metric::kMajor, facts) + bound(subject, Metric::kEffective, facts);
  const double wanted = truth.wanted.to_double();
  const double boundary = probes > truth.probes ? probes - 0.5 : probes + 0.5;
  return std::abs(probes - truth.probes) == 1 && std::abs(wanted - boundary) <= 2 * (wanted + 1) * radii;
}

}  // namespace

Compared compare(Subject subject, const Case& of, const Truth& truth, const Facts& facts, const Outcome& outcome) {
  Compared compared;
  Errors& errors = compared.errors;
  const auto set = [&](Metric metric, double error) { errors[static_cast<std::size_t>(metric)] = error; };
  const bool unit = is_unit(subject);
  const bool single = is_float32(subject);
  const ExactEllipse& ellipse = truth.ellipse;

  const bool unit_overflows = unit && facts.major >= 0x1p69;
  const bool float32_overflows = single && facts.major >= 0x1p126;
  if (float32_overflows) return compared;
  if (!unit_overflows) {
    const double forgiven = unit ? kLeastUnitRadius : single ? 0x1p-148 : 0x1p-1073;
    set(Metric::kMajor, relative(outcome.major, ellipse.major_radius, forgiven));
    // Nothing is relative to 0.
    if (ellipse.minor_radius > Real(0) || facts.major == 0 || !std::isfinite(outcome.minor)) {
      set(Metric::kMinor, relative(outcome.minor, ellipse.minor_radius, forgiven));
    }
    set(Metric::kEffective, relative(effective(outcome.major, outcome.minor), effective(ellipse), forgiven));
  }
  const double least_axis = unit ? kLeastUnitRadius : single ? 0x1p-100 : 0;
  if (ellipse.has_axis && facts.major >= least_axis) set(Metric::kAxis, axis_error(outcome, ellipse));

  const Truth* side = &truth;
  std::optional<Truth> other;
  compared.other_probes = outcome.probes != truth.line.probes;
  if (compared.other_probes && !unit && near_boundary(subject, facts, truth.line, outcome.probes)) {
    compared.other_side = true;
    other = with_probes(truth, of, outcome.probes);
    side = &*other;
  }
  const double raw = saturated(side->line.level.to_double());
  set(Metric::kRawLevel, std::isnan(outcome.raw_level) ? kLost : std::abs(saturated(outcome.raw_level) - raw));
  if (std::abs(raw) < 31) set(Metric::kRawLevel, absolute(saturated(outcome.raw_level), side->line.level));
  set(Metric::kLevel, absolute(outcome.level, side->level));
  set(Metric::kColour, absolute(outcome.colour, side->colour));
  return compared;
}

void Measure::add(double error, double most, const Case& of) {
  const bool has_value = std::isfinite(error);
  if (has_value) {
    ++count;
    sum += error;
    if (error >= worst && lost == 0) worst_case = of;
    worst = std::max(worst, error);
  } else {
    if (lost == 0) worst_case = of;
    ++lost;
  }
  if (!std::isfinite(most)) return;
  ++bounded;
  const double share = error == 0 ? 0 : has_value ? error / most : kLost;
  if (share >= worst_share) {
    worst_share = share;
    worst_share_case = of;
  }
}

}  // namespace feline::stability
