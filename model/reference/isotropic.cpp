// SPDX-License-Identifier: Apache-2.0
#include "model/reference/isotropic.h"

#include <algorithm>
#include <cmath>

namespace feline::reference {
namespace {

// Of two levels as near, the finer one.
const Level& nearest_level(const MipMap& map, const Lookup& lookup) {
  const double level = std::clamp(isotropic_level(map, lookup), 0.0, static_cast<double>(map.last_level()));
  return map.levels[static_cast<std::size_t>(std::ceil(level - 0.5))];
}

}  // namespace

double isotropic_level(const MipMap& map, const Lookup& lookup) {
  const Gradients<double> gradients = in_texels(lookup.gradients, map.base());
  return std::log2(std::max(length(gradients.x), length(gradients.y)));
}

Colour nearest_filter(const MipMap& map, const Lookup& lookup, Cost& cost) {
  cost.add(1, 1, 1);
  return nearest(map.base(), map.wrapping, lookup.position.u, lookup.position.v);
}

Colour bilinear_filter(const MipMap& map, const Lookup& lookup, Cost& cost) {
  cost.add(1, 4, 1);
  return two_by_two(map.base(), map.wrapping, ProbeKernel::kBilinear, lookup.position.u, lookup.position.v);
}

Colour bicubic_filter(const MipMap& map, const Cubic& cubic, const Lookup& lookup, Cost& cost) {
  cost.add(1, 16, 2);
  return bicubic(map.base(), map.wrapping, cubic, lookup.position.u, lookup.position.v);
}

Colour nearest_mip_filter(const MipMap& map, const Lookup& lookup, Cost& cost) {
  cost.add(1, 1, 1);
  return nearest(nearest_level(map, lookup), map.wrapping, lookup.position.u, lookup.position.v);
}

Colour bilinear_mip_filter(const MipMap& map, const Lookup& lookup, Cost& cost) {
  cost.add(1, 4, 1);
  return two_by_two(nearest_level(map, lookup), map.wrapping, ProbeKernel::kBilinear, lookup.position.u,
                    lookup.position.v);
}

Colour trilinear_filter(const MipMap& map, const Lookup& lookup, Cost& cost) {
  return mip_probe(map, ProbeKernel::kBilinear, isotropic_level(map, lookup), lookup.position.u, lookup.position.v,
                   cost);
}

}  // namespace feline::reference
