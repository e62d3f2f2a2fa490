// SPDX-License-Identifier: Apache-2.0
#include "testbench/scenes/paint.h"

#include <cmath>

namespace feline {
namespace {

// An invertible mixing of 32 bits: odd multipliers and xor-shifts.
constexpr std::uint32_t scramble(std::uint32_t bits) {
  bits ^= bits >> 16;
  bits *= 0x9e3779b1u;
  bits ^= bits >> 15;
  bits *= 0x85ebca77u;
  bits ^= bits >> 14;
  return bits;
}

constexpr double fade(double f) { return f * f * (3.0 - 2.0 * f); }

}  // namespace

double hash01(int x, int y, int seed) {
  std::uint32_t bits = scramble(static_cast<std::uint32_t>(seed) + 0x6a09e667u);
  bits = scramble(bits ^ static_cast<std::uint32_t>(x));
  bits = scramble(bits ^ static_cast<std::uint32_t>(y));
  return bits / 4294967296.0;
}

double noise(double x, double y, int period, int seed) {
  const int column = static_cast<int>(x);
  const int row = static_cast<int>(y);
  const int x0 = column % period;
  const int x1 = (column + 1) % period;
  const int y0 = row % period;
  const int y1 = (row + 1) % period;
  const double fx = fade(x - column);
  const double fy = fade(y - row);
  const double top = hash01(x0, y0, seed) * (1.0 - fx) + hash01(x1, y0, seed) * fx;
  const double bottom = hash01(x0, y1, seed) * (1.0 - fx) + hash01(x1, y1, seed) * fx;
  return top * (1.0 - fy) + bottom * fy;
}

double fractal_noise(double x, double y, int period, int seed) {
  return (4.0 * noise(x, y, period, seed) + 2.0 * noise(2.0 * x, 2.0 * y, 2 * period, seed + 1) +
          noise(4.0 * x, 4.0 * y, 4 * period, seed + 2)) /
         7.0;
}

std::uint8_t quantize(double value) { return static_cast<std::uint8_t>(std::floor(clamp01(value) * 255.0 + 0.5)); }

}  // namespace feline
