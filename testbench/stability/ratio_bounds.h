// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace feline {

// How far the unit's radii are from those of the derivatives that group rounded to nearest: stored over real. An
// effective radius is max(minor, kLeastLine * major), as plan widens the minor radius to 2/(maxProbes + 1) *
// lengthFactor of the major one, here at the paper's least lengthFactor, 0.9625, as the machine holds it.
inline constexpr double kLeastLine = 2.0 / 17 * 246 / 256;

struct RatioBounds {
  double major_low = 1, major_high = 1;  // of stored to real, 1 included
  double effective_low = 1, effective_high = 1;

  void include(const RatioBounds& other) {
    major_low = std::min(major_low, other.major_low);
    major_high = std::max(major_high, other.major_high);
    effective_low = std::min(effective_low, other.effective_low);
    effective_high = std::max(effective_high, other.effective_high);
  }
  double low() const { return std::min(major_low, effective_low); }
  double high() const { return std::max(major_high, effective_high); }
};

// Found by footprint_bounds_long over all quadruples, rounded outwards: Simple's against its own formulas with exact
// components, Table's against the ideal ellipse.
inline constexpr RatioBounds kSimpleRatios{0.989197, 1.01101, 0.839172, 1.19165};
inline constexpr RatioBounds kTableRatios{0.949113, 1.062829, 0.737734, 1.420546};

}  // namespace feline
