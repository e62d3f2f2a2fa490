// SPDX-License-Identifier: Apache-2.0
#include "model/reference/line.h"

#include <cmath>

#include "model/reference/ewa.h"

namespace feline::reference {
namespace {

// The weighted mean of probe(place) over the line.
template <typename Probe>
Colour mean_of_probes(const MipMap& map, const ProbeLine& line, const Vector2<double>& middle, Probe probe) {
  const Vector2<double> step = normalized(line.step, map.base());
  Colour sum{};
  double weights = 0;
  for (int i = 0; i < line.probes; ++i) {
    // n/2 of WRL 99/1, 3.1.
    const double distance = i - (line.probes - 1) / 2.0;
    const double weight = line.falloff == 0 ? 1 : std::exp(-line.falloff * distance * distance);
    add_weighted(sum, weight, probe(middle + distance * step));
    weights += weight;
  }
  for (double& channel : sum) channel /= weights;
  return sum;
}

}  // namespace

Colour sample_line(const MipMap& map, ProbeKernel kernel, const ProbeLine& line, const Vector2<double>& middle,
                   Cost& cost) {
  return mean_of_probes(map, line, middle, [&](const Vector2<double>& at) {
    return mip_probe(map, kernel, line.level_of_detail, at.u, at.v, cost);
  });
}

Colour sample_line_of_circles(const MipMap& map, const ProbeLine& line, const Vector2<double>& middle, Cost& cost) {
  // Of the line's own radius, which is never below a texel.
  constexpr EwaParameters kCircle{true, 0, false};
  const double radius = std::exp2(line.level_of_detail);
  const Gradients<double> circle{normalized({radius, 0}, map.base()), normalized({0, radius}, map.base())};
  return mean_of_probes(map, line, middle, [&](const Vector2<double>& at) {
    return ewa_filter(map, kCircle, {at, circle}, cost);
  });
}

}  // namespace feline::reference
