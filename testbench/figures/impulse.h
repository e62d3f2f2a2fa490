// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/reference/filters.h"
#include "testbench/mip_chain.h"

namespace feline {

// The weight with which each texel around a lookup enters its colour, by the distance between the two: a filter's
// impulse response. A filter that reads mip levels weighs a texel by its place in their grids, too; the shape is then
// the mean over all such places. The grid is periodic and as large as the texture.
struct FilterShape {
  static constexpr int kTexels = 128;

  explicit FilterShape(int points_per_texel);
  int per_texel;                // points of the grid
  int half_side;                // of the grid: per_texel * kTexels / 2
  std::vector<double> weights;  // row-major, a texel's weight and a density per square texel at once

  // The texel `column` and `row` grid steps from the lookup, each -half_side to half_side - 1.
  double& at(int column, int row) { return weights[index(column, row)]; }
  double at(int column, int row) const { return weights[index(column, row)]; }

  double volume() const;  // 1 for a filter that keeps a constant texture constant
  double lowest() const;
  double highest() const;

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row + half_side) * static_cast<std::size_t>(2 * half_side) +
           static_cast<std::size_t>(column + half_side);
  }
};

// A colour from a texture of kTexels x kTexels at a place in texels.
using ProbedFilter =
    std::function<reference::Colour(const reference::MipMap& map, const reference::Vector2<double>& texels)>;

// Exact but for the float32 of mip levels. `coarsest`: the last level that the filter reads, whose grid repeats after
// 2^coarsest texels.
FilterShape impulse_response(const ProbedFilter& filter, MipFilter mip_filter, int coarsest, int per_texel);

// exp(-2 d^2) inside an ellipse, 0 outside, its volume scaled to 1: what every filter here aims at (WRL 99/1, figure
// 4).
FilterShape gaussian_shape(const reference::Gradients<double>& texels, int per_texel);

// The total variation distance, half the integral of the difference: the part of the weight that is at wrong places. 0
// for equal shapes, 1 for shapes that nowhere overlap; ripples below zero can make it more. Both have the same grid.
double distance(const FilterShape& a, const FilterShape& b);

}  // namespace feline
