// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "model/reference/lookup.h"
#include "model/reference/mip_map.h"
#include "tests/support/random.h"

// Textures whose every level is known in closed form.
namespace feline::reference {

inline constexpr Wrapping kRepeated{};
inline constexpr Wrapping kClamped{Wrap::kClampToEdge, Wrap::kClampToEdge, {}};

inline Texel grey(double value) {
  const auto v = static_cast<float>(value);
  return {v, v, v, v};
}

// value(s, t) at the texels' middles.
template <typename Value>
Level level_of(int width, int height, const Value& value) {
  Level level{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) level.texels.push_back(value((x + 0.5) / width, (y + 0.5) / height));
  return level;
}

// value(s, t, level), down to 1 x 1.
template <typename Value>
MipMap map_of(int width, int height, const Wrapping& wrapping, const Value& value) {
  MipMap map{{}, wrapping};
  for (int k = 0; k == 0 || std::max(width, height) >> k > 0; ++k) {
    map.levels.push_back(level_of(std::max(1, width >> k), std::max(1, height >> k),
                                  [&](double s, double t) { return value(s, t, k); }));
  }
  return map;
}

// value(s, t, halvings of s, halvings of t).
template <typename Value>
RipMap rip_of(int width, int height, const Wrapping& wrapping, const Value& value) {
  RipMap map{0, 0, {}, wrapping};
  while (width >> map.columns > 0) ++map.columns;
  while (height >> map.rows > 0) ++map.rows;
  for (int j = 0; j < map.rows; ++j)
    for (int i = 0; i < map.columns; ++i)
      map.levels.push_back(
          level_of(width >> i, height >> j, [&, i, j](double s, double t) { return value(s, t, i, j); }));
  return map;
}

// Red rises along s and green along t by 1/1024 a texel of level 0, which float holds exactly; blue is constant.
inline Texel ramp_texel(double s, double t, int width, int height) {
  return {static_cast<float>(s * width / 1024), static_cast<float>(t * height / 1024), 0.75F, 1};
}
inline MipMap ramp_map(int width, int height) {
  return map_of(width, height, kClamped, [&](double s, double t, int) { return ramp_texel(s, t, width, height); });
}

// Each level is as bright as its number: what a filter returns is its level of detail.
inline MipMap level_map(int width, int height) {
  return map_of(width, height, kRepeated, [](double, double, int k) { return grey(k); });
}

inline Level noise_level(int width, int height, Random& random) {
  return level_of(width, height, [&](double, double) {
    Texel texel{};
    for (float& channel : texel) channel = static_cast<float>(random.unit());
    return texel;
  });
}

// Sizes are powers of two.
inline MipMap box_map(Level base, const Wrapping& wrapping) {
  MipMap map{{std::move(base)}, wrapping};
  while (map.levels.back().width > 1 || map.levels.back().height > 1) {
    const Level& fine = map.levels.back();
    const int dx = fine.width > 1 ? 2 : 1;
    const int dy = fine.height > 1 ? 2 : 1;
    Level coarse{fine.width / dx, fine.height / dy, {}};
    for (int y = 0; y < coarse.height; ++y) {
      for (int x = 0; x < coarse.width; ++x) {
        Colour sum{};
        for (int i = 0; i < dx * dy; ++i) add_weighted(sum, 1.0 / (dx * dy), fine.at(dx * x + i % dx, dy * y + i / dx));
        Texel texel{};
        for (std::size_t c = 0; c < 4; ++c) texel[c] = static_cast<float>(sum[c]);
        coarse.texels.push_back(texel);
      }
    }
    map.levels.push_back(std::move(coarse));
  }
  return map;
}

// Like a photograph: waves of up to `highest` periods that fade with their frequency, around 1/2; repeats.
inline Level natural_level(int size, int highest, int waves, Random& random) {
  std::vector<std::array<double, 4>> sum;
  for (int i = 0; i < waves; ++i) {
    const double kx = static_cast<double>(random.between(-highest, highest));
    const double ky = static_cast<double>(random.between(-highest, highest));
    sum.push_back({kx, ky, random.real(0, 2 * std::numbers::pi), 0.5 / (1 + std::hypot(kx, ky))});
  }
  return level_of(size, size, [&](double s, double t) {
    double value = 0.5;
    for (const auto& [kx, ky, phase, height] : sum)
      value += height * std::cos(2 * std::numbers::pi * (kx * s + ky * t) + phase);
    return grey(value);
  });
}

// Gradients in texels whose ellipse is known: radii, the angle of its major axis, and which conjugate radii they are.
inline Gradients<double> gradients_of_ellipse(double major, double minor, double angle, double turn) {
  const Vector2<double> a{major * std::cos(angle), major * std::sin(angle)};
  const Vector2<double> b{-minor * std::sin(angle), minor * std::cos(angle)};
  return {std::cos(turn) * a + std::sin(turn) * b, std::cos(turn) * b - std::sin(turn) * a};
}

inline Gradients<double> random_gradients(Random& random, double major, double minor) {
  return gradients_of_ellipse(major, minor, random.real(0, 2 * std::numbers::pi), random.real(0, 2 * std::numbers::pi));
}

// A lookup at (u, v) texels of level 0 with gradients in texels.
inline Lookup lookup_at(const Level& base, double u, double v, const Gradients<double>& gradients) {
  return {normalized({u, v}, base), {normalized(gradients.x, base), normalized(gradients.y, base)}};
}

// 10^low .. 10^high, evenly in the logarithm.
inline double log_uniform(Random& random, double low, double high) { return std::pow(10, random.real(low, high)); }

inline double angle_between_lines(const Vector2<double>& a, const Vector2<double>& b) {
  return std::atan2(std::abs(a.u * b.v - a.v * b.u), std::abs(a.u * b.u + a.v * b.v));
}

}  // namespace feline::reference
