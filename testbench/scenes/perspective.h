// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "testbench/scenes/scene.h"

namespace feline {

// Perspective-correct interpolation over a triangle, as a rasteriser does it: an attribute divided
// by w is linear in screen space, and so is 1 / w (Stanford CS248A, lecture 4, 2025, "Efficient
// perspective-correct interpolation").

// A projected vertex: screen position in pictures, w > 0, texture coordinates.
struct Vertex {
  double x;
  double y;
  double w;
  double s;
  double t;
};

// f(x, y) = a x + b y + c
struct LinearFunction {
  double a;
  double b;
  double c;

  constexpr Dual operator()(const Dual& x, const Dual& y) const { return a * x + b * y + c; }
};

class PerspectiveTriangle {
 public:
  // The vertices are not in line.
  constexpr explicit PerspectiveTriangle(const std::array<Vertex, 3>& vertices)
      : vertices_(vertices),
        s_over_w_(fit({at(0).s / at(0).w, at(1).s / at(1).w, at(2).s / at(2).w})),
        t_over_w_(fit({at(0).t / at(0).w, at(1).t / at(1).w, at(2).t / at(2).w})),
        one_over_w_(fit({1.0 / at(0).w, 1.0 / at(1).w, 1.0 / at(2).w})) {}

  // Edges included.
  constexpr bool covers(double x, double y) const {
    const double e0 = edge(0, 1, x, y);
    const double e1 = edge(1, 2, x, y);
    const double e2 = edge(2, 0, x, y);
    return (e0 >= 0 && e1 >= 0 && e2 >= 0) || (e0 <= 0 && e1 <= 0 && e2 <= 0);
  }

  constexpr TexturePoint interpolate(const Dual& x, const Dual& y) const {
    const Dual w = 1.0 / one_over_w_(x, y);
    return {s_over_w_(x, y) * w, t_over_w_(x, y) * w};
  }

 private:
  constexpr const Vertex& at(std::size_t i) const { return vertices_[i]; }

  // Twice the signed area of the triangle from, to, (x, y).
  constexpr double edge(std::size_t from, std::size_t to, double x, double y) const {
    return (at(to).x - at(from).x) * (y - at(from).y) - (at(to).y - at(from).y) * (x - at(from).x);
  }

  // The linear function with these values at the vertices (Cramer's rule).
  constexpr LinearFunction fit(const std::array<double, 3>& f) const {
    const double x1 = at(1).x - at(0).x;
    const double y1 = at(1).y - at(0).y;
    const double x2 = at(2).x - at(0).x;
    const double y2 = at(2).y - at(0).y;
    const double area = x1 * y2 - x2 * y1;
    const double a = ((f[1] - f[0]) * y2 - (f[2] - f[0]) * y1) / area;
    const double b = ((f[2] - f[0]) * x1 - (f[1] - f[0]) * x2) / area;
    return {a, b, f[0] - a * at(0).x - b * at(0).y};
  }

  std::array<Vertex, 3> vertices_;
  LinearFunction s_over_w_;
  LinearFunction t_over_w_;
  LinearFunction one_over_w_;
};

}  // namespace feline
