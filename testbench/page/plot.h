// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace feline::page {

struct Point {
  double x = 0;
  double y = 0;
  std::string label{};  // beside the point; none where empty
};

enum class Style {
  kPoints,
  kLines,
  kLinesPoints,
  kDashed,  // a line for a bound
  kBars,    // upright, on the axis' low end
};

struct Series {
  std::string name;  // in the legend; left out of it where empty
  std::vector<Point> points{};
  Style style = Style::kLinesPoints;
};

struct Axis {
  std::string label{};
  bool log = false;  // of base 10
  // The ends; equal: as the points need.
  double low = 0;
  double high = 0;
  // Names of 0, 1, 2, ... instead of numbers; not with log.
  std::vector<std::string> names{};
};

struct Plot {
  std::string name;  // letters, digits, '-' or '_': keeps the plots of a page apart
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series{};
  int width = 560;  // of the view box; text is 15 high
  int height = 400;
};

// The plot as an SVG element for a page, drawn by gnuplot: without network references, in the page's text colour, the
// same bytes for the same plot. Points that are not finite, or not above 0 on a logarithmic axis, are left out, and a
// line is broken there. Throws InputError when there is no gnuplot, or when it fails.
std::string svg(const Plot& plot);

// Fails as a plot would without gnuplot, before the work that is to be plotted.
void check_gnuplot();

}  // namespace feline::page
