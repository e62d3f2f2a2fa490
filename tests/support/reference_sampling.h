// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/reference/mip_map.h"

// Filters by their definition: every texel that a kernel reaches, weighted and divided by the sum of the weights.
namespace feline::reference {

// OpenGL 4.6, table 8.20, in its words.
inline std::int64_t gl_modulo(std::int64_t a, std::int64_t b) { return ((a % b) + b) % b; }
inline std::int64_t gl_mirror(std::int64_t a) { return a >= 0 ? a : -(1 + a); }
inline std::int64_t gl_wrap(std::int64_t coordinate, std::int64_t size, Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat: return gl_modulo(coordinate, size);
    case Wrap::kMirroredRepeat: return (size - 1) - gl_mirror(gl_modulo(coordinate, 2 * size) - size);
    case Wrap::kClampToEdge: return std::clamp<std::int64_t>(coordinate, 0, size - 1);
    default: return std::clamp<std::int64_t>(coordinate, -1, size);
  }
}
inline Texel gl_texel(const Level& level, const Wrapping& wrapping, std::int64_t x, std::int64_t y) {
  const auto i = gl_wrap(x, level.width, wrapping.s);
  const auto j = gl_wrap(y, level.height, wrapping.t);
  if (i < 0 || j < 0 || i >= level.width || j >= level.height) return wrapping.border;
  return level.at(static_cast<int>(i), static_cast<int>(j));
}

struct WeightedSum {
  Colour colour{};
  double weight = 0;
  int texels = 0;

  Colour mean() const {
    Colour result{};
    add_weighted(result, 1 / weight, colour);
    return result;
  }
};

// weight(du, dv): of a texel so far from (u, v), 0 or less outside; all within `reach` are asked.
template <typename Weight>
WeightedSum sum_texels(const Level& level, const Wrapping& wrapping, double u, double v, double reach,
                       const Weight& weight) {
  WeightedSum sum;
  for (auto y = static_cast<std::int64_t>(std::floor(v - reach)); static_cast<double>(y) <= v + reach; ++y) {
    for (auto x = static_cast<std::int64_t>(std::floor(u - reach)); static_cast<double>(x) <= u + reach; ++x) {
      const double w = weight(static_cast<double>(x) + 0.5 - u, static_cast<double>(y) + 0.5 - v);
      if (w == 0) continue;
      add_weighted(sum.colour, w, gl_texel(level, wrapping, x, y));
      sum.weight += w;
      ++sum.texels;
    }
  }
  return sum;
}

inline double tent(double d) { return std::max(0.0, 1 - std::abs(d)); }

// (s, t) as the filters have it.
inline Colour tent_sample(const Level& level, const Wrapping& wrapping, double s, double t) {
  return sum_texels(level, wrapping, s * level.width, t * level.height, 1,
                    [](double du, double dv) { return tent(du) * tent(dv); })
      .mean();
}

inline Colour mix(const Colour& a, const Colour& b, double fraction) {
  Colour result{};
  for (std::size_t c = 0; c < 4; ++c) result[c] = a[c] + fraction * (b[c] - a[c]);
  return result;
}

// "Linearly interpolate the bilinear interpolation results from two adjacent levels" (CS248A lecture 4).
inline Colour trilinear_sample(const MipMap& map, double level_of_detail, double s, double t) {
  const double clamped = std::clamp(level_of_detail, 0.0, static_cast<double>(map.levels.size() - 1));
  const auto fine = static_cast<std::size_t>(clamped);
  const auto coarse = std::min(fine + 1, map.levels.size() - 1);
  return mix(tent_sample(map.levels[fine], map.wrapping, s, t), tent_sample(map.levels[coarse], map.wrapping, s, t),
             clamped - std::floor(clamped));
}

inline double distance(const Colour& a, const Colour& b) {
  double most = 0;
  for (std::size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

}  // namespace feline::reference
