// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/page/plot.h"

namespace feline::page {

// Heights over a square grid around the origin, twice: from above a corner, and as a map of contour lines.
struct SurfacePlot {
  std::string name;   // letters, digits, '-' or '_': keeps the plots of a page apart
  std::string title;  // for those who do not see it
  std::string x_label;
  std::string y_label;
  double step = 1;                // between neighbours of the grid, in the axes' units
  int side = 0;                   // of the grid, odd: the middle one is the origin
  std::vector<double> heights{};  // row-major, side * side; std::invalid_argument otherwise
  // Ends of the vertical axis, so that plots can share one; contour lines stand at equal parts of `high`.
  double low = 0;
  double high = 1;
  int contours = 20;
  std::vector<Point> outline{};  // a dashed line on the map, for what the heights ought to fill
  int width = 860;
  int height = 400;
};

// As svg of a Plot (page/plot.h).
std::string svg(const SurfacePlot& plot);

}  // namespace feline::page
