// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/gradients.h"
#include "testbench/stability/real.h"

namespace feline::stability {

// The ellipse of two gradients at 200 bits.
struct ExactEllipse {
  Real major_radius;
  Real minor_radius;
  Real angle;             // of the major axis, from u towards v; 0 for a circle
  bool has_axis = false;  // no circle, and no point

  // major/minor, 1 for two zero gradients, infinity for parallel ones.
  double condition() const;
  // 1 - (minor/major)^2: what an error of the axis does to the shape is in proportion to it, and how far the axis turns
  // for a change of the gradients is in inverse proportion.
  Real axis_weight() const;
};

// Shares no formula with model/reference/ellipse.h but the determinant: the radii are the square roots of the
// eigenvalues of M^T M, (|x|^2 + |y|^2 +- sqrt((|x|^2 - |y|^2)^2 + 4 (x.y)^2))/2, the smaller one by way of the
// determinant, which 200 bits hold exactly unless a component is 2^100 times another; the axis is the eigenvector of
// M M^T. tests/testbench/stability_test.cpp compares with the difference itself.
ExactEllipse exact_ellipse(const reference::Gradients<Real>& gradients);

}  // namespace feline::stability
