// SPDX-License-Identifier: Apache-2.0
#include "model/reference/probe.h"

#include <algorithm>
#include <cmath>

namespace feline::reference {
namespace {

// A coordinate in texels of an image, whole part and fraction; NaN-free input of any size.
struct Place {
  std::int64_t whole;
  double fraction;
};

Place place(double coordinate) {
  const double whole = std::floor(coordinate);
  return {static_cast<std::int64_t>(whole), coordinate - whole};
}

// Into one period, so that a whole part fits whatever the coordinate is; clamps to where even the widest kernel of the
// smallest image reads nothing but what lies beyond the edge.
double reduce(double coordinate, Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat: return coordinate - std::floor(coordinate);
    case Wrap::kMirroredRepeat: return coordinate - 2 * std::floor(coordinate / 2);
    case Wrap::kClampToEdge:
    case Wrap::kClampToBorder: return std::clamp(coordinate, -2.0, 3.0);
  }
  return coordinate;
}

double far_weight(ProbeKernel kernel, double fraction) {
  return kernel == ProbeKernel::kBilinear ? fraction : 1 / (1 + std::exp(1 - 2 * fraction));
}

}  // namespace

Colour nearest(const Level& level, const Wrapping& wrapping, double s, double t) {
  const Place x = place(reduce(s, wrapping.s) * level.width);
  const Place y = place(reduce(t, wrapping.t) * level.height);
  Colour colour{};
  add_weighted(colour, 1, wrapped_texel(level, wrapping, x.whole, y.whole));
  return colour;
}

Colour two_by_two(const Level& level, const Wrapping& wrapping, ProbeKernel kernel, double s, double t) {
  const Place x = place(reduce(s, wrapping.s) * level.width - 0.5);
  const Place y = place(reduce(t, wrapping.t) * level.height - 0.5);
  const double right = far_weight(kernel, x.fraction);
  const double below = far_weight(kernel, y.fraction);
  Colour colour{};
  add_weighted(colour, (1 - right) * (1 - below), wrapped_texel(level, wrapping, x.whole, y.whole));
  add_weighted(colour, right * (1 - below), wrapped_texel(level, wrapping, x.whole + 1, y.whole));
  add_weighted(colour, (1 - right) * below, wrapped_texel(level, wrapping, x.whole, y.whole + 1));
  add_weighted(colour, right * below, wrapped_texel(level, wrapping, x.whole + 1, y.whole + 1));
  return colour;
}

double cubic_weight(const Cubic& cubic, double distance) {
  const double x = std::abs(distance);
  const auto& [b, c] = cubic;
  if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + 6 - 2 * b) / 6;
  if (x < 2) return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + 8 * b + 24 * c) / 6;
  return 0;
}

Colour bicubic(const Level& level, const Wrapping& wrapping, const Cubic& cubic, double s, double t) {
  const Place x = place(reduce(s, wrapping.s) * level.width - 0.5);
  const Place y = place(reduce(t, wrapping.t) * level.height - 0.5);
  Colour colour{};
  for (int row = -1; row <= 2; ++row) {
    Colour along{};
    for (int column = -1; column <= 2; ++column) {
      add_weighted(along, cubic_weight(cubic, column - x.fraction),
                   wrapped_texel(level, wrapping, x.whole + column, y.whole + row));
    }
    add_weighted(colour, cubic_weight(cubic, row - y.fraction), along);
  }
  return colour;
}

Colour mip_probe(const MipMap& map, ProbeKernel kernel, double level_of_detail, double s, double t, Cost& cost) {
  const double level = std::clamp(level_of_detail, 0.0, static_cast<double>(map.last_level()));
  const auto fine = static_cast<std::size_t>(level);
  const double fraction = level - static_cast<double>(fine);
  cost.add(1, fraction == 0 ? 4 : 8, 1);
  Colour colour = two_by_two(map.levels[fine], map.wrapping, kernel, s, t);
  if (fraction == 0) return colour;
  for (double& channel : colour) channel *= 1 - fraction;
  add_weighted(colour, fraction, two_by_two(map.levels[fine + 1], map.wrapping, kernel, s, t));
  return colour;
}

}  // namespace feline::reference
