// SPDX-License-Identifier: Apache-2.0
// Feline of WRL 99/1, 3.1, for any real type: from an ellipse to a line of probes and to a colour. model/reference has
// the same in double alone; here float32, double and 200 bits run the same source, so that only rounding differs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "model/reference/ellipse.h"
#include "testbench/stability/real.h"
#include "testbench/stability/textures.h"

namespace feline::stability {

inline constexpr int kMaxProbes = kDefaultConfig.max_probes;

// A whole number that fits.
inline std::int64_t whole(float value) { return static_cast<std::int64_t>(value); }
inline std::int64_t whole(double value) { return static_cast<std::int64_t>(value); }
inline std::int64_t whole(const Real& value) { return value.floored(0); }

template <typename T>
struct Line {
  int probes = 1;
  T wanted = T(1);               // fProbes
  T level{};                     // log2 of the radius that fits the probes, in octaves; not clamped
  reference::Vector2<T> step{};  // texels of level 0
  T falloff{};                   // the weight of a probe d steps from the middle is exp(-falloff d^2) / sum
};

// `probes`, if given, instead of rounding fProbes: a boundary seen from its other side. Any input gives a count within
// 1 .. kMaxProbes; NaN radii give kMaxProbes.
template <typename T>
Line<T> plan_line(const reference::Axes<T>& axes, int smallest_level, std::optional<int> probes = {}) {
  using std::floor;
  using std::log2;
  Line<T> line;
  const T one(1);
  if (axes.major_radius < one) {  // magnified
    line.level = log2(axes.major_radius);
    return line;
  }
  const T& major = axes.major_radius;
  const T minor = axes.minor_radius < one ? one : axes.minor_radius;
  line.wanted = T(2) * major / minor - one;
  const T rounded = floor(line.wanted + T(0.5));
  int count = kMaxProbes;
  if (rounded < T(kMaxProbes)) count = rounded > one ? static_cast<int>(whole(rounded)) : 1;
  if (probes) count = *probes;
  const T fitted = T(count) < line.wanted ? T(2) * major / T(count + 1) : minor;
  line.level = log2(fitted);
  if (line.level > T(smallest_level)) return line;
  line.probes = count;
  if (count == 1) return line;
  const T step = T(2) * (major - fitted) / T(count - 1);
  line.step = (step / major) * axes.major;
  line.falloff = T(2) * (step / major) * (step / major);
  return line;
}

// Into 0 .. last, NaN stays NaN.
template <typename T>
T clamped_level(const T& level, int last) {
  if (level < T(0)) return T(0);
  return level > T(last) ? T(last) : level;
}

namespace detail {

// 2 x 2 texels of one level, repeated, by their distances.
template <typename T>
T bilinear(const MipLevel& level, const T& s, const T& t) {
  using std::floor;
  const auto place = [](const T& coordinate, int size, std::int64_t(&index)[2], T& fraction) {
    const T x = (coordinate - floor(coordinate)) * T(size) - T(0.5);
    const T low = floor(x);
    fraction = x - low;
    const std::int64_t first = whole(low);
    // -1 .. size, for a coordinate within 0 .. 1.
    index[0] = first < 0 ? size - 1 : first >= size ? 0 : first;
    index[1] = first + 1 >= size ? (first + 1 - size) % size : first + 1;
  };
  std::int64_t columns[2];
  std::int64_t rows[2];
  T right;
  T below;
  place(s, level.width, columns, right);
  place(t, level.height, rows, below);
  const auto texel = [&](int row, int column) {
    return T(level.texels[static_cast<std::size_t>(rows[row] * level.width + columns[column])]);
  };
  const T above = (T(1) - right) * texel(0, 0) + right * texel(0, 1);
  return (T(1) - below) * above + below * ((T(1) - right) * texel(1, 0) + right * texel(1, 1));
}

}  // namespace detail

// In codes, 0 .. 255; NaN where a coordinate or the level is no finite number.
template <typename T>
T line_colour(const Texture& texture, const Line<T>& line, const T& s, const T& t) {
  using std::exp;
  using std::floor;
  const int last = static_cast<int>(texture.levels.size()) - 1;
  const T level = clamped_level(line.level, last);
  if (!(level == level)) return level;
  const auto fine = static_cast<std::size_t>(whole(level));
  const T fraction = level - T(static_cast<double>(fine));
  const MipLevel& base = texture.levels.front();
  const T step_s = line.step.u / T(base.width);
  const T step_t = line.step.v / T(base.height);
  T sum(0);
  T weights(0);
  for (int i = 0; i < line.probes; ++i) {
    const T distance = T(i) - T(line.probes - 1) / T(2);
    const T weight = exp(-(line.falloff * distance * distance));
    const T at_s = s + distance * step_s;
    const T at_t = t + distance * step_t;
    // Infinity and NaN both fail.
    if (!(at_s - at_s == T(0)) || !(at_t - at_t == T(0))) return (at_s - at_s) + (at_t - at_t);
    T colour = detail::bilinear(texture.levels[fine], at_s, at_t);
    if (fraction > T(0)) {
      colour = (T(1) - fraction) * colour + fraction * detail::bilinear(texture.levels[fine + 1], at_s, at_t);
    }
    sum = sum + weight * colour;
    weights = weights + weight;
  }
  return sum / weights;
}

}  // namespace feline::stability
