// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "model/reference/ellipse.h"

namespace feline::reference {

// The two-part linear length of WRL 99/1, 3.2, as printed: -1.116 % to +1.213 % of the true one.
inline double approximate_length(const Vector2<double>& vector) {
  const double a = std::max(std::abs(vector.u), std::abs(vector.v));
  const double b = std::min(std::abs(vector.u), std::abs(vector.v));
  return b < 3 * a / 8 ? a + 5 * b / 32 : 109 * a / 128 + 35 * b / 64;
}

// Simple Feline, 3.2, and Texram, 2.3: the longer gradient is the major axis, the shortest of both gradients and both
// diagonals the minor radius. On a tie y is the longer one.
Axes<double> simple_axes(const Gradients<double>& gradients);

// Table Feline, 3.3, with the rotation corrected: the ellipse of the longer gradient's cell in the table that the unit
// has, too (tables/ellipse.h), everything around the table in double.
Axes<double> table_axes(const Gradients<double>& gradients);

// The same with a table of the caller's: entry (row, column) is uvScale, uvScale90, minor and major radius in units of
// the longer gradient.
struct EllipseTable {
  int rows = 0;
  int columns = 0;
  std::vector<std::array<double, 4>> entries;
};
Axes<double> table_axes(const Gradients<double>& gradients, const EllipseTable& table);

}  // namespace feline::reference
