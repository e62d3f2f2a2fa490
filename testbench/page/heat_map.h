// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace feline::page {

// The colour of a count on a logarithmic scale from 1, dark red, to `most`, nearly white; a slate that is not on that
// scale for 0.
std::array<int, 3> heat_colour(std::uint64_t count, std::uint64_t most);

// Counts over rows and columns.
struct HeatMap {
  std::string title;  // for those who do not see it
  std::string x_label;
  std::string y_label;
  int columns = 0;
  int rows = 0;
  std::vector<std::optional<std::uint64_t>> counts{};  // row-major from the top; none where nothing can be
  // Beside columns and rows; empty strings where there is no room for all.
  std::vector<std::string> column_names{};
  std::vector<std::string> row_names{};
  int cell_width = 28;  // of the view box; text is 15 high
  int cell_height = 22;
  int names_width = 74;   // what the names of rows and their label take
  int names_height = 18;  // what the names of columns take; above 18 they stand on end
};

// As an SVG element for a page: without network references, in the page's text colour. A count of 0 is a slate cell
// that is crossed out; each cell tells its count where the reader points. std::invalid_argument unless counts fill the
// map.
std::string svg(const HeatMap& map);

}  // namespace feline::page
