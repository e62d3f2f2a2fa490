// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/texture.h"

namespace feline {

// The procedural textures' tools: + - * / and sqrt on double and integer hashing only, so that,
// compiled with -ffp-contract=off, every host paints the same bytes.

// Encoded values, 0 to 1; out of range is clamped when stored.
struct Colour {
  double red;
  double green;
  double blue;
};

constexpr Colour operator*(double scale, const Colour& c) { return {scale * c.red, scale * c.green, scale * c.blue}; }

constexpr Colour operator+(const Colour& a, const Colour& b) {
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}

// a at amount 0, b at amount 1.
constexpr Colour mix(const Colour& a, const Colour& b, double amount) { return (1.0 - amount) * a + amount * b; }

constexpr double clamp01(double value) { return value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value; }

// 0 below edge - softness, 1 above edge + softness, a cubic between them; softness > 0.
constexpr double smooth_step(double edge, double softness, double value) {
  const double f = clamp01((value - edge + softness) / (2.0 * softness));
  return f * f * (3.0 - 2.0 * f);
}

// [0, 1), the same for the same three numbers.
double hash01(int x, int y, int seed);

// Value noise in [0, 1) with lattice points at the integers; x and y at least 0, periodic, period at
// least 1.
double noise(double x, double y, int period, int seed);

// Three octaves of it, in [0, 1).
double fractal_noise(double x, double y, int period, int seed);

std::uint8_t quantize(double value);

// RGBA8, alpha 255: each texel is colour(u, v) at its centre, u and v in texels. Shapes bring their
// own soft edges.
template <typename ColourAt>
MipLevel paint_rgba(int width, int height, ColourAt colour) {
  MipLevel level{width, height, {}};
  level.texels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const Colour texel = colour(column + 0.5, row + 0.5);
      level.texels.push_back(quantize(texel.red));
      level.texels.push_back(quantize(texel.green));
      level.texels.push_back(quantize(texel.blue));
      level.texels.push_back(255);
    }
  }
  return level;
}

}  // namespace feline
