// SPDX-License-Identifier: Apache-2.0
#include "model/reference/rip.h"

#include <algorithm>
#include <cmath>

namespace feline::reference {
namespace {

double halvings(double texels) { return texels > 1 ? std::log2(texels) : 0; }

// A level between two images: which, and how much of the second.
struct Between {
  int low;
  int high;
  double fraction;
};

Between between(double level, int last) {
  const double clamped = std::clamp(level, 0.0, static_cast<double>(last));
  const auto low = static_cast<int>(clamped);
  return {low, std::min(low + 1, last), clamped - low};
}

}  // namespace

RipLevel rip_level(const RipMap& map, const Lookup& lookup) {
  const Gradients<double> gradients = in_texels(lookup.gradients, map.at(0, 0));
  return {halvings(std::max(std::abs(gradients.x.u), std::abs(gradients.y.u))),
          halvings(std::max(std::abs(gradients.x.v), std::abs(gradients.y.v)))};
}

Colour rip_polygon_filter(const RipMap& map, const Lookup& polygon_middle, const Lookup& lookup, Cost& cost) {
  const RipLevel middle = rip_level(map, polygon_middle);
  const int ratio = static_cast<int>(std::ceil(middle.t)) - static_cast<int>(std::ceil(middle.s));
  const int shrink_s = std::min(std::max(-ratio, 0), map.columns - 1);
  const int shrink_t = std::min(std::max(ratio, 0), map.rows - 1);
  const Gradients<double> gradients = in_texels(lookup.gradients, map.at(shrink_s, shrink_t));
  const double level = halvings(std::max(length(gradients.x), length(gradients.y)));
  // The image's own mip levels go on until both sides are one texel.
  const int last = std::max(map.columns - 1 - shrink_s, map.rows - 1 - shrink_t);
  const Between levels = between(level, last);
  const auto read = [&](int step) {
    const Level& image = map.at(std::min(shrink_s + step, map.columns - 1), std::min(shrink_t + step, map.rows - 1));
    return two_by_two(image, map.wrapping, ProbeKernel::kBilinear, lookup.position.u, lookup.position.v);
  };
  cost.add(1, levels.fraction == 0 ? 4 : 8, 1);
  Colour colour{};
  add_weighted(colour, 1 - levels.fraction, read(levels.low));
  if (levels.fraction != 0) add_weighted(colour, levels.fraction, read(levels.high));
  return colour;
}

Colour rip_pixel_filter(const RipMap& map, const Lookup& lookup, Cost& cost) {
  const RipLevel level = rip_level(map, lookup);
  const Between s = between(level.s, map.columns - 1);
  const Between t = between(level.t, map.rows - 1);
  Colour colour{};
  double images = 0;
  const auto add = [&](int i, int j, double weight) {
    if (weight == 0) return;
    add_weighted(colour, weight,
                 two_by_two(map.at(i, j), map.wrapping, ProbeKernel::kBilinear, lookup.position.u, lookup.position.v));
    images += 1;
  };
  add(s.low, t.low, (1 - s.fraction) * (1 - t.fraction));
  add(s.high, t.low, s.fraction * (1 - t.fraction));
  add(s.low, t.high, (1 - s.fraction) * t.fraction);
  add(s.high, t.high, s.fraction * t.fraction);
  cost.add(1, 4 * images, std::ceil(images / 2));
  return colour;
}

}  // namespace feline::reference
