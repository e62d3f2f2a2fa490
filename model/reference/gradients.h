// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace feline::reference {

// Real is float, double, or a number of higher precision with the same functions.
template <typename Real>
struct Vector2 {
  Real u;
  Real v;
};

template <typename Real>
Vector2<Real> operator+(const Vector2<Real>& a, const Vector2<Real>& b) {
  return {a.u + b.u, a.v + b.v};
}

template <typename Real>
Vector2<Real> operator-(const Vector2<Real>& a, const Vector2<Real>& b) {
  return {a.u - b.u, a.v - b.v};
}

template <typename Real>
Vector2<Real> operator*(const Real& scale, const Vector2<Real>& a) {
  return {scale * a.u, scale * a.v};
}

template <typename Real>
Real length(const Vector2<Real>& a) {
  using std::hypot;
  return hypot(a.u, a.v);
}

// How a texture coordinate moves a pixel to the right and a pixel down: (du/dx, dv/dx) and (du/dy, dv/dy), in texels of
// the level that is spoken of.
template <typename Real>
struct Gradients {
  Vector2<Real> x;
  Vector2<Real> y;
};

}  // namespace feline::reference
