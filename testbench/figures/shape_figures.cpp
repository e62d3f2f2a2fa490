// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/reference/approximate_axes.h"
#include "model/reference/ewa.h"
#include "testbench/figures/figure.h"
#include "testbench/figures/shapes.h"
#include "testbench/page/sheet.h"
#include "testbench/page/surface.h"

namespace feline {
namespace {

using reference::Gradients;

// How a figure is drawn: from -extent to extent texels.
struct Frame {
  int per_texel;
  int extent;
  double low;
  double high;
};
constexpr Frame kEllipseFrame{4, 6, -0.02, 0.4};
constexpr Frame kProbeFrame{8, 3, -0.02, 0.6};

Gradients<double> scaled(double scale) { return {scale * kPaperGradients.x, scale * kPaperGradients.y}; }

std::vector<page::Point> ellipse_outline(const Gradients<double>& texels) {
  constexpr int kPoints = 96;
  std::vector<page::Point> points;
  for (int i = 0; i <= kPoints; ++i) {
    const double turn = 2 * std::numbers::pi * i / kPoints;
    const auto at = std::cos(turn) * texels.x + std::sin(turn) * texels.y;
    points.push_back({at.u, at.v});
  }
  return points;
}

std::string draw(const std::string& name, const std::string& title, const FilterShape& shape, const Frame& frame,
                 const Gradients<double>& outline, const std::string& caption) {
  const int half = frame.extent * frame.per_texel;
  page::SurfacePlot plot{name, title, "u, texels", "v, texels", 1.0 / frame.per_texel, 2 * half + 1};
  for (int row = -half; row <= half; ++row) {
    for (int column = -half; column <= half; ++column) plot.heights.push_back(shape.at(column, row));
  }
  plot.low = frame.low;
  plot.high = frame.high;
  plot.outline = ellipse_outline(outline);
  return page::to_svg({title, {{page::svg(plot), title, ""}}, 1, plot.width, plot.height, caption});
}

nlohmann::ordered_json facts_of(const FilterShape& shape) {
  return {
      {"volume", shape.volume()}, {"highest", shape.highest()}, {"lowest", shape.lowest()}, {"middle", shape.at(0, 0)}};
}

// Distances to figure 4's shape over an octave of sizes, in which the probes meet every mix of mip levels.
nlohmann::ordered_json distances_over_octave(int figure) {
  constexpr int kSizes = 4;
  double least = 1e9;
  double most = 0;
  double mean = 0;
  for (int i = 0; i < kSizes; ++i) {
    const Gradients<double> texels = scaled(std::exp2(static_cast<double>(i) / kSizes));
    const double here =
        distance(impulse_response(plan_shape(figure, texels), MipFilter::kLanczos, 2), gaussian_shape(texels, 2));
    least = std::min(least, here);
    most = std::max(most, here);
    mean += here / kSizes;
  }
  return {{"least", least}, {"mean", mean}, {"most", most}};
}

FigureOutput make_gaussian() {
  const FilterShape shape = gaussian_shape(kPaperGradients, kEllipseFrame.per_texel);
  const reference::Axes<double> axes = reference::ellipse_axes(kPaperGradients);
  const reference::Axes<double> simple = reference::simple_axes(kPaperGradients);
  const double texram = length(kPaperGradients.y) / length(kPaperGradients.x);
  // The filter itself, whose level 0 unites the ellipse with a reconstruction filter of a texel.
  const FilterShape level0 = impulse_response(
      [](const reference::MipMap& map, const reference::Vector2<double>& texels) {
        const Gradients<double> gradients{normalized(kPaperGradients.x, map.base()),
                                          normalized(kPaperGradients.y, map.base())};
        reference::Cost cost;
        return ewa_filter(map, {}, {normalized(texels, map.base()), gradients}, cost);
      },
      MipFilter::kBox, 0, kEllipseFrame.per_texel);
  const double ideal_probes = 2 * axes.major_radius / axes.minor_radius - 1;
  const double simple_probes = 2 * simple.major_radius / simple.minor_radius - 1;
  nlohmann::ordered_json facts{
      {"gradients", {kPaperGradients.x.u, kPaperGradients.x.v, kPaperGradients.y.u, kPaperGradients.y.v}},
      {"major_radius", axes.major_radius},
      {"minor_radius", axes.minor_radius},
      {"degrees", std::atan2(axes.major.v, axes.major.u) * 180 / std::numbers::pi},
      {"ideal_probes", ideal_probes},
      {"simple_probes", simple_probes},
      {"texram_probes", texram},
      {"ewa_with_reconstruction_distance", distance(level0, shape)}};
  facts.update(facts_of(shape));
  return {draw("feline_4", "An affine projection of a Gaussian filter into texture space", shape, kEllipseFrame,
               kPaperGradients,
               fmt::format("After WRL 99/1, figure 4: exp(-2 d²) inside the ellipse, volume 1. Gradients ({}, {}) and "
                           "({}, {}) texels, chosen so that Simple Feline wants {:.2f} probes, Texram {:.2f} and the "
                           "ideal computation {:.2f}, as the report prints; minor radius {:.2f} texel. The map's lines "
                           "are {:.2f} apart, dashed is the ellipse.",
                           kPaperGradients.x.u, kPaperGradients.x.v, kPaperGradients.y.u, kPaperGradients.y.v,
                           simple_probes, texram, ideal_probes, axes.minor_radius,
                           kEllipseFrame.high / page::SurfacePlot{}.contours)),
          facts};
}

struct ShapeFigure {
  int number;
  std::string title;
  std::string description;
};

// Never a negative zero.
double to_thousandths(double value) { return std::round(1000 * value) / 1000 + 0.0; }

std::string probe_text(const PlannedShape& planned) {
  const double radius = std::exp2(planned.line.level_of_detail);
  const char* const kernel = planned.kernel == reference::ProbeKernel::kGaussian ? "mip-mapped Gaussian" : "trilinear";
  if (planned.line.probes == 1) return fmt::format("one {} probe of nominal radius {:.2f} texels", kernel, radius);
  return fmt::format("{} {} probes of nominal radius {:.2f} texels, {:.2f} radii apart", planned.line.probes, kernel,
                     radius, length(planned.line.step) / radius);
}

FigureOutput make_shape(const ShapeFigure& figure) {
  const bool detail = figure.number == 15 || figure.number == 16;
  const Frame& frame = detail ? kProbeFrame : kEllipseFrame;
  const std::string name = fmt::format("feline_{}", figure.number);
  const PlannedShape planned = plan_shape(figure.number, kPaperGradients);
  const FilterShape shape = impulse_response(planned, MipFilter::kLanczos, frame.per_texel);
  nlohmann::ordered_json facts{
      {"probes", planned.line.probes},
      {"level_of_detail", planned.line.level_of_detail},
      {"step", length(planned.line.step)},
      {"step_in_probe_radii", length(planned.line.step) / std::exp2(planned.line.level_of_detail)}};
  facts.update(facts_of(shape));
  std::string caption = fmt::format(
      "After WRL 99/1, figure {}: {}. The weight of each texel by its place around the lookup: the filter's impulse "
      "response, mip levels by a Lanczos filter, mean over all places of a texel in their grids; volume {:.3f}, "
      "highest {:.3f}, lowest {:.3f}.",
      figure.number, probe_text(planned), shape.volume(), shape.highest(), to_thousandths(shape.lowest()));
  if (detail) {
    const double circle = std::sqrt(2);
    caption += " Dashed: the nominal radius. The vertical axis reaches half as far again as in the other figures.";
    return {draw(name, figure.title, shape, frame, {{circle, 0}, {0, circle}}, caption), facts};
  }
  const FilterShape goal = gaussian_shape(kPaperGradients, frame.per_texel);
  facts["distance"] = distance(shape, goal);
  facts["distance_with_box_mip_levels"] = distance(impulse_response(planned, MipFilter::kBox, frame.per_texel), goal);
  facts["distance_over_octave"] = distances_over_octave(figure.number);
  caption += fmt::format(
      " Part of the weight at other places than in figure 4 (total variation distance): {:.3f}; over an octave of "
      "sizes {:.3f} on the mean.",
      facts["distance"].get<double>(), facts["distance_over_octave"]["mean"].get<double>());
  return {draw(name, figure.title, shape, frame, kPaperGradients, caption), facts};
}

}  // namespace

std::vector<Figure> shape_figures() {
  const std::vector<ShapeFigure> shapes{
      {5, "A trilinear filter approximation", "filter shape of trilinear"},
      {7, "Worst-case 2-probe Texram filter", "filter shape of Texram, rounded down to 2 probes"},
      {8, "Best-case 4-probe Texram filter", "filter shape of Texram, rounded up to 4 probes"},
      {12, "The desired Feline computations", "filter shape of Feline with the exact ellipse"},
      {13, "Simple Feline", "filter shape of Simple Feline"},
      {14, "Simple Feline with blurFactor 1.31 and aliasFactor effectively 1.26",
       "filter shape of Simple Feline with fewer probes"},
      {15, "A trilinear filter with a nominal radius of √2", "filter shape of a single trilinear probe"},
      {16, "A mip-mapped Gaussian filter with nominal radius of √2", "filter shape of a single Gaussian probe"},
      {17, "Figure 14 using a Gaussian probe", "filter shape of Simple Feline with fewer, Gaussian probes"}};
  std::vector<Figure> all{{"feline_4", "filter shape of EWA: an affine Gaussian, which the others aim at", ".svg",
                           [](const FigureOptions&) { return make_gaussian(); }}};
  for (const ShapeFigure& shape : shapes) {
    all.push_back({fmt::format("feline_{}", shape.number), shape.description, ".svg",
                   [shape](const FigureOptions&) { return make_shape(shape); }});
  }
  return all;
}

}  // namespace feline
