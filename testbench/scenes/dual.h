// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace feline {

// A value and its derivatives along the two axes of the picture (forward-mode differentiation):
// a projection is written once, on Dual, and its gradients come with it, exact to rounding.
// dx and dy are per whole picture width and height. Only + - * / and sqrt, which IEEE 754 rounds
// correctly: with -ffp-contract=off every host computes the same bits.
struct Dual {
  double value = 0.0;
  double dx = 0.0;
  double dy = 0.0;

  constexpr Dual() = default;
  constexpr Dual(double constant) : value(constant) {}  // implicit: constants mix with Duals
  constexpr Dual(double v, double along_x, double along_y) : value(v), dx(along_x), dy(along_y) {}
};

constexpr Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.dx + b.dx, a.dy + b.dy}; }

constexpr Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.dx - b.dx, a.dy - b.dy}; }

constexpr Dual operator-(const Dual& a) { return {-a.value, -a.dx, -a.dy}; }

constexpr Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.dx * b.value + a.value * b.dx, a.dy * b.value + a.value * b.dy};
}

constexpr Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return {quotient, (a.dx - quotient * b.dx) / b.value, (a.dy - quotient * b.dy) / b.value};
}

// a > 0: the derivative has no value at 0.
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, a.dx / (2.0 * root), a.dy / (2.0 * root)};
}

// A sine-like wave of period 2 and amplitude 1, twice continuously differentiable: the odd quintic
// on [-1, 1] that is 1 at 1/2 and whose value and second derivative vanish at 0 and 1.
inline Dual wave(const Dual& a) {
  const double period = 2.0 * std::floor((a.value + 1.0) / 2.0);
  const Dual f = a - Dual(period);
  const Dual square = f * f;
  return 1.28 * f * (7.0 / 3.0 - 10.0 / 3.0 * square + square * square);
}

// Its derivative, for normals of surfaces that it shapes.
inline Dual wave_slope(const Dual& a) {
  const double period = 2.0 * std::floor((a.value + 1.0) / 2.0);
  const Dual f = a - Dual(period);
  const Dual square = f * f;
  return 1.28 * (7.0 / 3.0 - 10.0 * square + 5.0 * square * square);
}

}  // namespace feline
