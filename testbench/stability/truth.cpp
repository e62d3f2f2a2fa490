// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/truth.h"

#include <limits>

namespace feline::stability {

double ExactEllipse::condition() const {
  if (!(major_radius > Real(0))) return 1;
  if (!(minor_radius > Real(0))) return std::numeric_limits<double>::infinity();
  return (major_radius / minor_radius).to_double();
}

Real ExactEllipse::axis_weight() const {
  if (!has_axis) return Real(0);
  const Real ratio = minor_radius / major_radius;
  return Real(1) - ratio * ratio;
}

ExactEllipse exact_ellipse(const reference::Gradients<Real>& gradients) {
  const auto& [x, y] = gradients;
  ExactEllipse ellipse;
  const Real xx = x.u * x.u + x.v * x.v;
  const Real yy = y.u * y.u + y.v * y.v;
  const Real xy = x.u * y.u + x.v * y.v;
  const Real root = sqrt((xx - yy) * (xx - yy) + Real(4) * xy * xy);
  ellipse.major_radius = sqrt((xx + yy + root) / Real(2));
  if (!(ellipse.major_radius > Real(0))) return ellipse;
  ellipse.minor_radius = abs(x.u * y.v - x.v * y.u) / ellipse.major_radius;
  // M M^T is ((p, q), (q, r)).
  const Real difference = (x.u - x.v) * (x.u + x.v) + (y.u - y.v) * (y.u + y.v);  // p - r
  const Real twice_q = Real(2) * (x.u * x.v + y.u * y.v);
  ellipse.has_axis = !(difference == Real(0) && twice_q == Real(0));
  ellipse.angle = ellipse.has_axis ? atan2(twice_q, difference) / Real(2) : Real(0);
  return ellipse;
}

}  // namespace feline::stability
