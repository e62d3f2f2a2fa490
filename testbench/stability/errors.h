// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "testbench/stability/bounds.h"

namespace feline::stability {

// Forward error of each metric: none where it is not defined for the case, infinite where the subject has no finite
// value for what has one.
//   radii   a difference of two least denormals of the type is forgiven, and 2^-57 texels in the unit, whose footprints
//           below that are points; the unit's radii where it says overflow, and float32's where texels exceed 2^126,
//           have no error: no number stands for them
//   minor   where the true one is not 0, or both are
//   axis    where the truth is no circle, and of a radius whose components are no denormals
using Errors = std::array<std::optional<double>, kMetrics.size()>;

struct Compared {
  Errors errors;
  // A probe count other than the truth's, at an fProbes so near a boundary that the radii's bound allows it: level and
  // colour are then compared with the truth's other side. Formulas only; the unit's bounds include it.
  bool other_side = false;
  bool other_probes = false;  // a probe count other than the truth's, whatever the reason
};
Compared compare(Subject subject, const Case& of, const Truth& truth, const Facts& facts, const Outcome& outcome);

// All cases of one class, subject and metric.
struct Measure {
  std::uint64_t count = 0;  // with a value
  std::uint64_t lost = 0;   // without
  double worst = 0;         // of those with a value
  double sum = 0;
  Case worst_case;  // a lost one if any is
  std::uint64_t bounded = 0;
  double worst_share = 0;  // of error to bound, infinite for a lost value that has a bound
  Case worst_share_case;

  double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
  bool holds() const { return worst_share <= 1; }
  void add(double error, double most, const Case& of);
};

}  // namespace feline::stability
