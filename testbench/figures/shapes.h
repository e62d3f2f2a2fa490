// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "model/reference/line.h"
#include "testbench/figures/impulse.h"

namespace feline {

// The gradients behind WRL 99/1's figures 4 to 17, which prints results of them only: Simple Feline wants 4.97 probes,
// Texram 2.97, the ideal computation takes 6. Ours were found from these. The ratio of the gradients' lengths is
// Texram's 2.97. 6.00 ideal probes make the ellipse 3.5 times as long as wide, and so set the angle between the
// gradients, 60.9 degrees: for radii R and r and lengths L and l, R/r + r/R = (L/l + l/L) / sin(angle). They are turned
// until Simple Feline's linear lengths give 4.97 where true ones would give 4.94, and scaled until the minor radius is
// one texel: the ideal probes then read level 0 alone.
inline constexpr reference::Gradients<double> kPaperGradients{{-0.062, 1.160}, {2.920, 1.838}};

// A shape of these figures: probes on a line.
struct PlannedShape {
  reference::ProbeLine line;
  reference::ProbeKernel kernel = reference::ProbeKernel::kBilinear;
};

// By the figure's number: 5, 7, 8, 12 to 17.
PlannedShape plan_shape(int figure, const reference::Gradients<double>& texels);

FilterShape impulse_response(const PlannedShape& planned, MipFilter mip_filter, int per_texel);

}  // namespace feline
