// SPDX-License-Identifier: Apache-2.0
#include "testbench/page/surface.h"

#include <fmt/format.h>

#include <stdexcept>

#include "testbench/page/gnuplot.h"

namespace feline::page {
namespace {

std::string grid(const SurfacePlot& plot) {
  const auto side = static_cast<std::size_t>(plot.side);
  if (plot.side % 2 == 0 || plot.heights.size() != side * side) {
    throw std::invalid_argument("heights that are no square of an odd side");
  }
  const int middle = plot.side / 2;
  std::string text;
  for (int row = 0; row < plot.side; ++row) {
    for (int column = 0; column < plot.side; ++column) {
      const auto index = static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column);
      text += fmt::format("{:g} {:g} {:.5f}\n", plot.step * (column - middle), plot.step * (row - middle),
                          plot.heights[index]);
    }
    text += '\n';
  }
  return text;
}

std::string outline(const SurfacePlot& plot) {
  std::string text;
  for (const Point& point : plot.outline) text += fmt::format("{} {} 0\n", point.x, point.y);
  return text.empty() ? "NaN NaN NaN\n" : text;
}

std::string script(const SurfacePlot& plot) {
  const int middle = plot.side / 2;
  const double extent = plot.step * middle;
  const double spacing = plot.high / plot.contours;
  std::string text = fmt::format("$grid << EOD\n{}EOD\n$outline << EOD\n{}EOD\n", grid(plot), outline(plot));
  text += fmt::format(
      "unset key\nunset colorbox\nset xrange [{0}:{1}]\nset yrange [{0}:{1}]\nset zrange [{2}:{3}]\n"
      "set cbrange [0:{3}]\nset palette defined (0 '#eaf3fb', 0.25 '#a6cee3', 0.6 '#3f8fc5', 1 '#08468c')\n"
      "set contour base\nset cntrparam cubicspline levels incremental {4},{4},{3}\nunset surface\n"
      "set table $contours\nsplot $grid\nunset table\nunset contour\nset surface\n",
      -extent, extent, plot.low, plot.high, spacing);
  text += fmt::format(
      "set multiplot\nset size 0.6,1.12\nset origin 0,-0.02\nset xyplane at {}\nset view 56,28,0.95,1.4\nset border "
      "31\n"
      "set xlabel {} offset 0,-0.2\nset ylabel {} offset 0,-0.2\nset xtics 2 offset 0,-0.3\nset ytics 2 offset "
      "0.5,-0.2\nset pm3d depthorder\nsplot $grid with pm3d\n",
      plot.low, quoted(plot.x_label), quoted(plot.y_label));
  text += fmt::format(
      "set size 0.4,0.98\nset origin 0.6,0\nset size ratio -1\nset xtics 2 nomirror offset 0,0\n"
      "set ytics 2 nomirror offset 0,0\nset xlabel {} offset 0,0\nset ylabel {} offset 0,0\nset border 3\n"
      "set grid lc rgb '#a0808080'\n"
      "plot $outline using 1:2 with lines lc rgb '#d55e00' lw 1.5 dt 2, $contours using 1:2 with lines lc rgb "
      "'#0072b2' lw 0.8\nunset multiplot\n",
      quoted(plot.x_label), quoted(plot.y_label));
  return text;
}

}  // namespace

std::string svg(const SurfacePlot& plot) {
  std::string drawn = run_gnuplot(script(plot), {plot.name, plot.title, plot.width, plot.height});
  // The mesh's lines as the strokes of its faces: gnuplot would write four paths a face.
  constexpr std::string_view kPlain = "<g stroke='none' shape-rendering='crispEdges'>";
  const std::size_t at = drawn.find(kPlain);
  if (at != std::string::npos) {
    drawn.replace(at, kPlain.size(), "<g stroke='#30404c' stroke-width='0.35' stroke-linejoin='round'>");
  }
  return drawn;
}

}  // namespace feline::page
