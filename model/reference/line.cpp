// SPDX-License-Identifier: Apache-2.0
#include "model/reference/line.h"

#include <cmath>

namespace feline::reference {

Colour sample_line(const MipMap& map, ProbeKernel kernel, const ProbeLine& line, const Vector2<double>& middle,
                   Cost& cost) {
  const Vector2<double> step = normalized(line.step, map.base());
  Colour sum{};
  double weights = 0;
  for (int i = 0; i < line.probes; ++i) {
    // n/2 of WRL 99/1, 3.1.
    const double distance = i - (line.probes - 1) / 2.0;
    const double weight = line.falloff == 0 ? 1 : std::exp(-line.falloff * distance * distance);
    const Vector2<double> at = middle + distance * step;
    add_weighted(sum, weight, mip_probe(map, kernel, line.level_of_detail, at.u, at.v, cost));
    weights += weight;
  }
  for (double& channel : sum) channel /= weights;
  return sum;
}

}  // namespace feline::reference
