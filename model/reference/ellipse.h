// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <type_traits>

#include "model/reference/gradients.h"

namespace feline::reference {

// The footprint of a round pixel filter of radius one pixel: radii in the gradients' texels, minor <= major; `major`
// points along the major axis and is as long as the major radius.
template <typename Real>
struct Axes {
  Vector2<Real> major;
  Real major_radius;
  Real minor_radius;
};

// a b - c d within two units in the last place (Kahan's difference of products), where the type has a fused
// multiply-add.
template <typename Real>
Real difference_of_products(const Real& a, const Real& b, const Real& c, const Real& d) {
  if constexpr (std::is_floating_point_v<Real>) {
    const Real product = c * d;
    return std::fma(a, b, -product) + std::fma(-c, d, product);
  } else {
    return a * b - c * d;
  }
}

// A power of two that brings the gradients near 1, so that squares and products neither overflow nor vanish; 1 for a
// type of unlimited exponent and for gradients that are all zero.
template <typename Real>
Real unit_scale(const Gradients<Real>& g) {
  if constexpr (std::is_floating_point_v<Real>) {
    const Real largest = std::max({std::abs(g.x.u), std::abs(g.x.v), std::abs(g.y.u), std::abs(g.y.v)});
    return largest > 0 && std::isfinite(largest) ? std::scalbn(Real(1), std::ilogb(largest)) : Real(1);
  } else {
    return Real(1);
  }
}

// The exact ellipse: the radii are the singular values of the matrix whose columns are the gradients, the major axis is
// its first left singular vector. Equal to the printed formulas of WRL 99/1, 2.1 and 3.1, without their cancellation:
// the minor radius is the determinant over the major one, the angle half a sum of two arctangents. A circle's axis is
// any, here defined by atan2(0, 0) = 0; zero gradients give zero radii.
template <typename Real>
Axes<Real> ellipse_axes(const Gradients<Real>& gradients) {
  using std::abs;
  using std::atan2;
  using std::cos;
  using std::hypot;
  using std::sin;
  const Real scale = unit_scale(gradients);
  const Vector2<Real> x{gradients.x.u / scale, gradients.x.v / scale};
  const Vector2<Real> y{gradients.y.u / scale, gradients.y.v / scale};
  const Real half = Real(0.5);
  const Real e = half * (x.u + y.v);
  const Real f = half * (x.u - y.v);
  const Real g = half * (x.v + y.u);
  const Real h = half * (x.v - y.u);
  const Real major = hypot(e, h) + hypot(f, g);
  if (!(major > Real(0))) return {{Real(0), Real(0)}, Real(0), Real(0)};
  const Real minor = abs(difference_of_products(x.u, y.v, x.v, y.u)) / major;
  const Real angle = half * (atan2(h, e) + atan2(g, f));
  const Real major_radius = scale * major;
  // Rounding can leave the radii of a circle the wrong way round by a unit in the last place.
  return {
      {major_radius * cos(angle), major_radius * sin(angle)}, major_radius, scale * (minor < major ? minor : major)};
}

// d^2(u, v) = a u^2 + b u v + c v^2 (WRL 99/1, 2.1).
template <typename Real>
struct Quadratic {
  Real a;
  Real b;
  Real c;
};

// The coefficients as 2.1 prints them, with `widen` added to both squares: 0 as printed, 1 for Heckbert's union with
// the reconstruction filter (3.1). Parallel gradients have no ellipse without it.
template <typename Real>
Quadratic<Real> ellipse_coefficients(const Gradients<Real>& g, const Real& widen) {
  const Real a = g.x.v * g.x.v + g.y.v * g.y.v + widen;
  const Real b = Real(-2) * (g.x.u * g.x.v + g.y.u * g.y.v);
  const Real c = g.x.u * g.x.u + g.y.u * g.y.u + widen;
  const Real f = a * c - b * b / Real(4);
  return {a / f, b / f, c / f};
}

// Radii and axis from coefficients, as 2.1 and 3.1 print them, but that atan2 gives the angle, which has a value where
// A = C. For the study of their stability: everything else here uses ellipse_axes.
template <typename Real>
Axes<Real> printed_axes(const Quadratic<Real>& q) {
  using std::atan2;
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Real root = sqrt((q.a - q.c) * (q.a - q.c) + q.b * q.b);
  const Real major = sqrt(Real(1) / ((q.a + q.c - root) / Real(2)));
  const Real minor = sqrt(Real(1) / ((q.a + q.c + root) / Real(2)));
  // arctan(B/(A - C))/2, and a quarter turn more where that is the minor axis: A > C.
  const Real angle = atan2(-q.b, q.c - q.a) / Real(2);
  return {{major * cos(angle), major * sin(angle)}, major, minor};
}

}  // namespace feline::reference
