// SPDX-License-Identifier: Apache-2.0
#include "testbench/page/plot.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "testbench/page/gnuplot.h"

namespace feline::page {
namespace {

// Told apart by most eyes, on white and on black (Okabe and Ito, 2008, the yellow left out).
constexpr std::array<std::string_view, 7> kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                   "#e69f00", "#56b4e9", "#808080"};
constexpr std::array<int, 7> kShapes{7, 5, 9, 11, 13, 6, 4};

std::string axis_commands(char axis, const Axis& of) {
  std::string commands = fmt::format("set {}label {}{}\n", axis, quoted(of.label), axis == 'x' ? " offset 0,0.4" : "");
  if (of.log) commands += fmt::format("set logscale {0} 10\nset format {0} '%g'\n", axis);
  if (!of.names.empty()) {
    std::string names;
    for (std::size_t i = 0; i < of.names.size(); ++i) {
      names += fmt::format("{}{} {}", i == 0 ? "" : ",", quoted(of.names[i]), i);
    }
    commands += fmt::format("set {0}tics ({1}){2}\nset {0}range [-0.7:{3}]\n", axis, names,
                            axis == 'x' ? " rotate by -40 scale 0" : "", static_cast<double>(of.names.size()) - 0.3);
  } else if (of.low < of.high) {
    commands += fmt::format("set {}range [{}:{}]\n", axis, of.low, of.high);
  }
  return commands;
}

bool shown(const Axis& axis, double value) { return std::isfinite(value) && (!axis.log || value > 0); }

std::string block(const Plot& plot, const Series& series, bool labels) {
  std::string text;
  for (const Point& point : series.points) {
    if (!shown(plot.x, point.x) || !shown(plot.y, point.y)) {
      text += "\n";  // a gap in the line
    } else if (!labels) {
      text += fmt::format("{} {}\n", point.x, point.y);
    } else if (!point.label.empty()) {
      std::string label = point.label;
      for (char& c : label) c = c == '"' ? '\'' : c == '\n' || c == '\\' ? ' ' : c;
      text += fmt::format("{} {} \"{}\"\n", point.x, point.y, label);
    }
  }
  return text;
}

std::string look(Style style, std::size_t index) {
  const std::string_view colour = kColours[index % kColours.size()];
  const int shape = kShapes[index % kShapes.size()];
  switch (style) {
    case Style::kPoints: return fmt::format("points lc rgb '{}' pt {} ps 0.7", colour, shape);
    case Style::kLines: return fmt::format("lines lc rgb '{}' lw 2", colour);
    case Style::kLinesPoints: return fmt::format("linespoints lc rgb '{}' lw 2 pt {} ps 0.7", colour, shape);
    case Style::kDashed: return fmt::format("lines lc rgb '{}' lw 2 dt 2", colour);
    case Style::kBars: return fmt::format("boxes lc rgb '{}' fill solid 0.7 noborder", colour);
  }
  return {};
}

std::string script(const Plot& plot) {
  std::string text = fmt::format(
      "set title {}\nset key bmargin center horizontal\nset border 3\n"
      "set grid lc rgb '#a0808080'\nset tics nomirror\nset mxtics 1\nset mytics 1\nset boxwidth 0.8 / {}\n",
      quoted(plot.title), std::max<std::size_t>(plot.series.size(), 1));
  text += axis_commands('x', plot.x) + axis_commands('y', plot.y);
  std::string draw;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    const std::string data = block(plot, series, false);
    if (data.find_first_not_of('\n') == std::string::npos) continue;
    const std::string title = series.name.empty() ? "notitle" : "title " + quoted(series.name);
    text += fmt::format("$data{} << EOD\n{}EOD\n", i, data);
    // Bars of several series stand beside each other.
    const double aside = series.style != Style::kBars
                             ? 0
                             : 0.8 * ((static_cast<double>(i) + 0.5) / static_cast<double>(plot.series.size()) - 0.5);
    draw += fmt::format("{}$data{} using ($1{:+}):2 with {} {}", draw.empty() ? "plot " : ", ", i, aside,
                        look(series.style, i), title);
    const std::string labels = block(plot, series, true);
    if (labels.find_first_not_of('\n') == std::string::npos) continue;
    text += fmt::format("$label{} << EOD\n{}EOD\n", i, labels);
    draw += fmt::format(", $label{} using 1:2:3 with labels left offset 0.7,0.4 font ',12' notitle", i);
  }
  const auto empty_range = [](char axis, const Axis& of) {
    return of.low < of.high || !of.names.empty() ? std::string() : fmt::format("set {}range [1:10]\n", axis);
  };
  if (draw.empty()) draw = empty_range('x', plot.x) + empty_range('y', plot.y) + "plot NaN notitle";
  return text + draw + "\n";
}

}  // namespace

std::string svg(const Plot& plot) {
  return run_gnuplot(script(plot), {plot.name, plot.title, plot.width, plot.height});
}

}  // namespace feline::page
