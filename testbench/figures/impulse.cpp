// SPDX-License-Identifier: Apache-2.0
#include "testbench/figures/impulse.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/reference/ellipse.h"
#include "testbench/parallel.h"

namespace feline {
namespace {

constexpr int kTexels = FilterShape::kTexels;

double cell_area(const FilterShape& shape) { return 1.0 / (shape.per_texel * shape.per_texel); }

// All of the texture 0 but for one texel, which is 1 in every channel, and its mip levels.
reference::MipMap impulse_texture(int column, int row, MipFilter filter) {
  FloatLevel base{kTexels, kTexels, std::vector<float>(std::size_t{kTexels} * kTexels)};
  base.values[static_cast<std::size_t>(row) * kTexels + static_cast<std::size_t>(column)] = 1;
  reference::MipMap map;
  for (const FloatLevel& level : build_float_mip_chain(std::move(base), 1, filter, MipEdge::kRepeat)) {
    reference::Level stored{level.width, level.height, {}};
    stored.texels.reserve(level.values.size());
    for (const float value : level.values) stored.texels.push_back({value, value, value, value});
    map.levels.push_back(std::move(stored));
  }
  return map;
}

}  // namespace

FilterShape::FilterShape(int points_per_texel)
    : per_texel(points_per_texel),
      half_side(points_per_texel * kTexels / 2),
      weights(static_cast<std::size_t>(4) * static_cast<std::size_t>(half_side) * static_cast<std::size_t>(half_side)) {
}

double FilterShape::volume() const { return cell_area(*this) * std::accumulate(weights.begin(), weights.end(), 0.0); }
double FilterShape::lowest() const { return *std::ranges::min_element(weights); }
double FilterShape::highest() const { return *std::ranges::max_element(weights); }

FilterShape impulse_response(const ProbedFilter& filter, MipFilter mip_filter, int coarsest, int per_texel) {
  const int places = 1 << coarsest;
  FilterShape shape(per_texel);
  for (int place = 0; place < places * places; ++place) {
    const int x = place % places;
    const int y = place / places;
    const reference::MipMap map = impulse_texture(x, y, mip_filter);
    for_each_index(-shape.half_side, shape.half_side, [&](std::int64_t row) {
      const double v = y + 0.5 - static_cast<double>(row) / per_texel;
      for (int column = -shape.half_side; column < shape.half_side; ++column) {
        const double u = x + 0.5 - static_cast<double>(column) / per_texel;
        shape.at(column, static_cast<int>(row)) += filter(map, {u, v})[0] / (places * places);
      }
    });
  }
  return shape;
}

FilterShape gaussian_shape(const reference::Gradients<double>& texels, int per_texel) {
  const auto [a, b, c] = reference::ellipse_coefficients(texels, 0.0);
  FilterShape shape(per_texel);
  for (int row = -shape.half_side; row < shape.half_side; ++row) {
    for (int column = -shape.half_side; column < shape.half_side; ++column) {
      const double u = static_cast<double>(column) / per_texel;
      const double v = static_cast<double>(row) / per_texel;
      const double square = a * u * u + b * u * v + c * v * v;
      if (square <= 1) shape.at(column, row) = std::exp(-2 * square);
    }
  }
  const double volume = shape.volume();
  for (double& weight : shape.weights) weight /= volume;
  return shape;
}

double distance(const FilterShape& a, const FilterShape& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.weights.size(); ++i) sum += std::abs(a.weights[i] - b.weights[i]);
  return cell_area(a) * sum / 2;
}

}  // namespace feline
