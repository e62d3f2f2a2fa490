// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "tables/interval.h"
#include "tables/roms.h"

namespace feline {

// The ellipse of the longer vector (1, 0) and a shorter one, Feline 2.1, 3.1 and 3.3, in the order of a table entry:
// uvScale, uvScale90, minorRadiusScale, majorRadiusScale.
using EllipseScales = std::array<Interval, 4>;

// A point of cell (row, column): ratio = (row + x/steps)/rows, and the tangent (first half of the columns) or the
// cotangent (second half) of the angle = (column within the half + y/steps)/(columns/2); 0 <= x, y <= steps.
struct CellPoint {
  int row, column, x, y, steps;
};
EllipseScales ellipse_scales(int rows, int columns, const CellPoint& point);

// The four scales that a word of the table holds.
std::array<double, 4> entry_scales(const Config& config, std::uint64_t word);

}  // namespace feline
