// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/ellipse.h"
#include "model/reference/line.h"

namespace feline::reference {

// Feline, WRL 99/1: from an ellipse to probes along its major axis.

struct FelineParameters {
  bool ceiling = false;      // false: the rounding of 3.1, which has no factors; true: that of 3.4
  double length_factor = 1;  // <= 1, shortens the ellipse
  double blur_factor = 1;    // >= 1, widens it at most so much
  double alias_factor = 1;   // >= 1, spreads the probes at most so much
  int max_probes = 16;
};
inline constexpr FelineParameters kExact{};
inline constexpr FelineParameters kHighQuality{true, 0.9625, 1.15625, 1.1532, 16};
inline constexpr FelineParameters kHighEfficiency{true, 0.9625, 1.3125, 1.3544, 16};

// Both radii are at least a texel (3.1); a minor radius beyond the 1 x 1 level takes one probe.
ProbeLine plan_feline(const Axes<double>& axes, const FelineParameters& parameters, double smallest_level);

// How the ellipse is found: exactly (3.1), by Simple (3.2) or Table Feline (3.3).
using AxesFunction = Axes<double> (*)(const Gradients<double>&);

Colour feline_filter(const MipMap& map, AxesFunction axes, const FelineParameters& parameters, ProbeKernel kernel,
                     const Lookup& lookup, Cost& cost);

// The exact ellipse, and circles of texels for probes.
Colour feline_circles_filter(const MipMap& map, const FelineParameters& parameters, const Lookup& lookup, Cost& cost);

}  // namespace feline::reference
