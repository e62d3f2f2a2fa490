// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "model/reference/lookup.h"
#include "model/reference/probe.h"

namespace feline::reference {

// Probes on a line, which EXT, Texram and Feline all are: centred on the lookup, a step apart.
struct ProbeLine {
  int probes = 1;
  Vector2<double> step{};  // texels of level 0
  double level_of_detail = 0;
  double falloff = 0;  // the weight of a probe d steps from the middle is exp(-falloff d^2) / sum
};

// Bilinear or Gaussian 2 x 2 probes on two mip levels.
Colour sample_line(const MipMap& map, ProbeKernel kernel, const ProbeLine& line, const Vector2<double>& middle,
                   Cost& cost);

// Every texel in a circle of the line's own radius around each place, weighted by exp(-2 d^2): the probe that the 2 x 2
// texels stand for. Tells the error of the probes from the rest.
Colour sample_line_of_circles(const MipMap& map, const ProbeLine& line, const Vector2<double>& middle, Cost& cost);

}  // namespace feline::reference
