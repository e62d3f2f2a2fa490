// SPDX-License-Identifier: Apache-2.0
#include "model/reference/texram.h"

#include <algorithm>
#include <cmath>

namespace feline::reference {

int round_texram_probes(double ratio, int max_probes) {
  int probes = 1;
  while (2 * probes <= max_probes && ratio >= 1.5 * probes) probes *= 2;
  return probes;
}

ProbeLine plan_texram(const Gradients<double>& gradients, int max_probes) {
  const double x = length(gradients.x);
  const double y = length(gradients.y);
  const double longest = std::max(x, y);
  const double shortest = std::min({x, y, length(gradients.x + gradients.y), length(gradients.x - gradients.y)});
  // Below one texel there is nothing to tell apart, as in 3.1.
  const double minor = std::max(shortest, 1.0);
  ProbeLine line;
  if (longest <= 1) return line;
  const double ratio = longest / minor;
  line.probes = round_texram_probes(ratio, max_probes);
  const bool limited = ratio >= 1.5 * max_probes;
  line.step = 1.0 / line.probes * (x > y ? gradients.x : gradients.y);
  line.level_of_detail = std::log2(limited ? longest / line.probes : minor);
  return line;
}

Colour texram_filter(const MipMap& map, int max_probes, const Lookup& lookup, Cost& cost) {
  return sample_line(map, ProbeKernel::kBilinear, plan_texram(in_texels(lookup.gradients, map.base()), max_probes),
                     lookup.position, cost);
}

}  // namespace feline::reference
