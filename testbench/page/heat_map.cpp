// SPDX-License-Identifier: Apache-2.0
#include "testbench/page/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "testbench/page/html.h"

namespace feline::page {
namespace {

constexpr int kTop = 6;
constexpr int kLineHeight = 18;
constexpr int kBelow = 74;        // for the label and the legend
constexpr int kLeastCrossed = 8;  // of narrower cells nothing but their crosses would be seen
constexpr int kLegendWidth = 160;
constexpr int kLegendSteps = 32;

std::string colour_text(std::uint64_t count, std::uint64_t most) {
  const auto [red, green, blue] = heat_colour(count, most);
  return fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

std::string text(double x, double y, std::string_view anchor, std::string_view of) {
  if (of.empty()) return {};
  return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}'>{}</text>\n", x, y, anchor, escape(of));
}

std::string cells(const HeatMap& map, std::uint64_t most) {
  std::string rectangles;
  std::string crosses;
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      const auto& count = map.counts[static_cast<std::size_t>(row * map.columns + column)];
      if (!count) continue;
      const int x = map.names_width + column * map.cell_width;
      const int y = kTop + row * map.cell_height;
      rectangles += fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='{}'><title>{}</title></rect>\n", x, y,
                                map.cell_width, map.cell_height, colour_text(*count, most), *count);
      if (*count == 0 && map.cell_width >= kLeastCrossed)
        crosses += fmt::format("M{} {}l{} {}", x, y, map.cell_width, map.cell_height);
    }
  }
  return "<g shape-rendering='crispEdges'>\n" + rectangles + "</g>\n" +
         (crosses.empty() ? "" : fmt::format("<path d='{}' stroke='#33475b' stroke-width='1'/>\n", crosses));
}

std::string column_names(const HeatMap& map, int y) {
  std::string html;
  for (std::size_t i = 0; i < map.column_names.size(); ++i) {
    const double x = map.names_width + (static_cast<double>(i) + 0.5) * map.cell_width;
    if (map.names_height <= kLineHeight) {
      html += text(x, y + kLineHeight, "middle", map.column_names[i]);
    } else {
      html += fmt::format("<g transform='rotate(-90 {0:.1f} {1})'>\n{2}</g>\n", x + 5, y + 6,
                          text(x + 5, y + 6, "end", map.column_names[i]));
    }
  }
  return html;
}

std::string legend(int x, int y, std::uint64_t most) {
  std::string html =
      fmt::format("<rect x='{}' y='{}' width='22' height='14' fill='{}'/>\n", x, y, colour_text(0, most));
  html += fmt::format("<path d='M{} {}l22 14' stroke='#33475b' stroke-width='1'/>\n", x, y);
  html += text(x + 28, y + 12, "start", "never");
  if (most == 0) return html;
  const int bar = x + 100;
  html += "<g shape-rendering='crispEdges'>\n";
  for (int step = 0; step < kLegendSteps; ++step) {
    const double share = (step + 0.5) / kLegendSteps;
    const auto count = static_cast<std::uint64_t>(std::max(std::exp(share * std::log(static_cast<double>(most))), 1.0));
    html +=
        fmt::format("<rect x='{}' y='{}' width='{}' height='14' fill='{}'/>\n",
                    bar + step * kLegendWidth / kLegendSteps, y, kLegendWidth / kLegendSteps, colour_text(count, most));
  }
  html += "</g>\n" + text(bar - 6, y + 12, "end", "1");
  return html + text(bar + kLegendWidth + 6, y + 12, "start", fmt::format("{}", most));
}

}  // namespace

std::array<int, 3> heat_colour(std::uint64_t count, std::uint64_t most) {
  if (count == 0) return {138, 155, 172};
  // Black, red, yellow, white, without the ends that pages have themselves.
  constexpr double kLeast = 0.14;
  constexpr double kMost = 0.9;
  const double whole = std::log(static_cast<double>(std::max<std::uint64_t>(most, 2)));
  const double share = std::clamp(std::log(static_cast<double>(count)) / whole, 0.0, 1.0);
  const int value = static_cast<int>(765 * (kLeast + (kMost - kLeast) * share));
  return {std::clamp(value, 0, 255), std::clamp(value - 255, 0, 255), std::clamp(value - 510, 0, 255)};
}

std::string svg(const HeatMap& map) {
  const std::size_t size = static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  if (map.counts.size() != size) throw std::invalid_argument("counts that do not fill their map");
  std::uint64_t most = 0;
  for (const auto& count : map.counts) most = std::max(most, count.value_or(0));
  const int width = map.columns * map.cell_width;
  const int height = map.rows * map.cell_height;
  const int right = 16;
  const int left = map.names_width;
  const int bottom = kTop + height + map.names_height;
  std::string html = fmt::format(
      "<svg role='img' viewBox='0 0 {} {}' font-family='system-ui, sans-serif' font-size='15' fill='currentColor'>\n"
      "<title>{}</title>\n",
      left + width + right, bottom + kBelow, escape(map.title));
  html += cells(map, most) + column_names(map, kTop + height);
  for (std::size_t i = 0; i < map.row_names.size(); ++i) {
    html += text(left - 6, kTop + (static_cast<double>(i) + 0.5) * map.cell_height + 5, "end", map.row_names[i]);
  }
  html += text(left + 0.5 * width, bottom + 24, "middle", map.x_label);
  html += fmt::format("<g transform='rotate(-90 14 {0:.1f})'>\n{1}</g>\n", kTop + 0.5 * height,
                      text(14, kTop + 0.5 * height, "middle", map.y_label));
  return html + legend(left, bottom + 44, most) + "</svg>\n";
}

}  // namespace feline::page
