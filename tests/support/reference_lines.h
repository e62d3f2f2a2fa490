// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/line.h"
#include "tests/support/reference_images.h"
#include "tests/support/reference_sampling.h"

// Lines of probes by the papers' sums.
namespace feline::reference {

// WRL 99/1, 3.1: probes at n/2 steps from the middle, n = +-1, +-3 ... where their number is even and 0, +-2 ... where
// it is odd, each of weight(n/2), the sum divided by the weights'. (u, v) in texels of level 0.
template <typename Weight>
Colour sum_probes(const MipMap& map, int probes, double u, double v, const Vector2<double>& step,
                  double level_of_detail, const Weight& weight) {
  Colour sum{};
  double total = 0;
  for (int n = probes % 2 == 0 ? 1 : 0; n < probes; n += 2) {
    for (const int sign : {1, -1}) {
      if (n == 0 && sign < 0) continue;
      const double d = sign * n / 2.0;
      const double w = weight(d);
      add_weighted(sum, w,
                   trilinear_sample(map, level_of_detail, (u + d * step.u) / map.base().width,
                                    (v + d * step.v) / map.base().height));
      total += w;
    }
  }
  Colour mean{};
  add_weighted(mean, 1 / total, sum);
  return mean;
}

inline constexpr auto kEqualWeights = [](double) { return 1.0; };

}  // namespace feline::reference
