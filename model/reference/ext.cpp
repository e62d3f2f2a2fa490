// SPDX-License-Identifier: Apache-2.0
#include "model/reference/ext.h"

#include <algorithm>
#include <cmath>

namespace feline::reference {

ProbeLine plan_ext(const Gradients<double>& gradients, int max_anisotropy) {
  const double x = length(gradients.x);
  const double y = length(gradients.y);
  const double longest = std::max(x, y);
  ProbeLine line;
  if (longest == 0) return line;
  // A shorter gradient of zero asks for as many as there may be.
  line.probes = static_cast<int>(std::min(std::ceil(longest / std::min(x, y)), double(max_anisotropy)));
  line.step = 1.0 / (line.probes + 1) * (x > y ? gradients.x : gradients.y);
  line.level_of_detail = std::log2(longest / line.probes);
  return line;
}

Colour ext_filter(const MipMap& map, int max_anisotropy, const Lookup& lookup, Cost& cost) {
  return sample_line(map, ProbeKernel::kBilinear, plan_ext(in_texels(lookup.gradients, map.base()), max_anisotropy),
                     lookup.position, cost);
}

}  // namespace feline::reference
