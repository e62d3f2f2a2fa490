// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "tests/support/reference_images.h"
#include "tests/support/reference_sampling.h"

namespace feline::reference {

// EWA by WRL 99/1, 2.1: A, B, C and F as printed, with `widen` added to A_nn and C_nn (3.1), every texel of a box
// around the ellipse asked, and those of d^2 <= 1 weighted by exp(-2 d^2). Gradients and (u, v) in texels of the level.
inline WeightedSum brute_ewa(const Level& level, const Wrapping& wrapping, double u, double v,
                             const Gradients<double>& g, double widen) {
  const double a_nn = g.x.v * g.x.v + g.y.v * g.y.v + widen;
  const double b_nn = -2 * (g.x.u * g.x.v + g.y.u * g.y.v);
  const double c_nn = g.x.u * g.x.u + g.y.u * g.y.u + widen;
  const double f = a_nn * c_nn - b_nn * b_nn / 4;
  const double a = a_nn / f;
  const double b = b_nn / f;
  const double c = c_nn / f;
  return sum_texels(level, wrapping, u, v, std::sqrt(std::max(a_nn, c_nn)) + 1, [&](double du, double dv) {
    const double d2 = a * du * du + b * du * dv + c * dv * dv;
    return d2 <= 1 ? std::exp(-2 * d2) : 0;
  });
}

// The same in a level's texels.
inline Gradients<double> at_level(const Gradients<double>& g, int level) {
  const double scale = std::ldexp(1.0, -level);
  return {scale * g.x, scale * g.y};
}

// Rectangles of the grid of width x height texels that hold a texel of the ellipse.
inline int brute_stamps(int width, int height, double u, double v, const Gradients<double>& g, double widen) {
  std::set<std::pair<std::int64_t, std::int64_t>> stamps;
  const double a_nn = g.x.v * g.x.v + g.y.v * g.y.v + widen;
  const double b_nn = -2 * (g.x.u * g.x.v + g.y.u * g.y.v);
  const double c_nn = g.x.u * g.x.u + g.y.u * g.y.u + widen;
  const double f = a_nn * c_nn - b_nn * b_nn / 4;
  const auto reach = static_cast<std::int64_t>(std::sqrt(std::max(a_nn, c_nn))) + 2;
  const std::int64_t x0 = std::llround(std::floor(u));
  const std::int64_t y0 = std::llround(std::floor(v));
  for (std::int64_t y = y0 - reach; y <= y0 + reach; ++y) {
    for (std::int64_t x = x0 - reach; x <= x0 + reach; ++x) {
      const double du = static_cast<double>(x) + 0.5 - u;
      const double dv = static_cast<double>(y) + 0.5 - v;
      if (a_nn * du * du + b_nn * du * dv + c_nn * dv * dv <= f)
        stamps.insert({(x - gl_modulo(x, width)) / width, (y - gl_modulo(y, height)) / height});
    }
  }
  return static_cast<int>(stamps.size());
}

}  // namespace feline::reference
