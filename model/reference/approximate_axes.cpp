// SPDX-License-Identifier: Apache-2.0
#include "model/reference/approximate_axes.h"

#include "tables/ellipse.h"

namespace feline::reference {
namespace {

EllipseTable default_table() {
  const Rom rom = ellipse_rom(kDefaultConfig);
  EllipseTable table{kDefaultConfig.table_rows, kDefaultConfig.table_columns, {}};
  for (const std::uint64_t word : rom.words) table.entries.push_back(entry_scales(kDefaultConfig, word));
  return table;
}

}  // namespace

Axes<double> simple_axes(const Gradients<double>& gradients) {
  const double x_length = approximate_length(gradients.x);
  const double y_length = approximate_length(gradients.y);
  const double shortest = std::min({x_length, y_length, approximate_length(gradients.x + gradients.y),
                                    approximate_length(gradients.x - gradients.y)});
  if (x_length > y_length) return {gradients.x, x_length, shortest};
  return {gradients.y, y_length, shortest};
}

Axes<double> table_axes(const Gradients<double>& gradients) {
  static const EllipseTable table = default_table();
  return table_axes(gradients, table);
}

Axes<double> table_axes(const Gradients<double>& gradients, const EllipseTable& table) {
  const double x_length = approximate_length(gradients.x);
  const double y_length = approximate_length(gradients.y);
  const bool x_is_longer = x_length > y_length;
  const Vector2<double> longer = x_is_longer ? gradients.x : gradients.y;
  const double longer_length = std::max(x_length, y_length);
  if (longer_length == 0) return {{0, 0}, 0, 0};
  const double ratio = std::min(x_length, y_length) / longer_length;
  // Near 1, products neither overflow nor vanish.
  const double unit = unit_scale(gradients);
  const Vector2<double> x{gradients.x.u / unit, gradients.x.v / unit};
  const Vector2<double> y{gradients.y.u / unit, gradients.y.v / unit};
  const double cross = x.u * y.v - x.v * y.u;
  const double dot = x.u * y.u + x.v * y.v;
  const bool counter_clockwise = x_is_longer ^ (cross < 0) ^ (dot < 0);
  // The tangent serves the first half of the columns, the cotangent the second, which therefore runs backwards. A
  // shorter gradient of zero stands at a right angle.
  const double half = table.columns / 2.0;
  const bool shallow = std::abs(cross) < std::abs(dot);
  const double tangent = shallow ? std::abs(cross) / std::abs(dot) : cross == 0 ? 0 : std::abs(dot) / std::abs(cross);
  const int row = std::min(static_cast<int>(ratio * table.rows), table.rows - 1);
  const int column =
      (shallow ? 0 : static_cast<int>(half)) + std::min(static_cast<int>(tangent * half), static_cast<int>(half) - 1);
  const auto& [along, across, minor_scale, major_scale] =
      table.entries[static_cast<std::size_t>(row * table.columns + column)];
  const double minor_radius = longer_length * minor_scale;
  const double major_radius = longer_length * major_scale;
  // Orthogonal and parallel gradients are the axes themselves: nothing is turned.
  const double turn = cross == 0 || dot == 0 ? 0 : counter_clockwise ? across : -across;
  return {{longer.u * along - longer.v * turn, longer.v * along + longer.u * turn}, major_radius, minor_radius};
}

}  // namespace feline::reference
