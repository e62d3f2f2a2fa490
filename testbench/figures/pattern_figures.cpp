// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/reference/ellipse.h"
#include "model/reference/vertex_based.h"
#include "testbench/figures/figure.h"
#include "testbench/figures/shapes.h"
#include "testbench/page/html.h"
#include "testbench/page/sheet.h"

namespace feline {
namespace {

using reference::AxisSystem;
using reference::Gradients;
using reference::ProbePattern;
using reference::Vector2;

// A footprint, in texels of level 0, and the axes that a system makes of it.
struct Domain {
  std::string label;
  std::string name;  // for the facts
  AxisSystem system;
  Gradients<double> gradients;
};

// The same ellipse seen from a screen that is turned by 45 degrees: gradients of equal length.
Gradients<double> turned_screen(const Gradients<double>& gradients) {
  const reference::Axes<double> axes = reference::ellipse_axes(gradients);
  const double ratio = axes.minor_radius / axes.major_radius;
  const Vector2<double> minor{-ratio * axes.major.v, ratio * axes.major.u};
  const double half = std::sqrt(0.5);
  return {half * (axes.major + minor), half * (axes.major - minor)};
}

Gradients<double> axes_of(const Domain& domain) {
  return vertex_axes(domain.system, domain.gradients, reference::Level{1, 1, {}});
}

double longer_gradient(const Domain& domain) {
  return std::max(length(domain.gradients.x), length(domain.gradients.y));
}

// The ellipse in black, probes in grey, as dark as they weigh and half as wide as they are.
std::string draw_pattern(const Domain& domain, const ProbePattern& pattern) {
  constexpr double kAcross = 4;  // texels from the middle to the edges
  constexpr double kUp = 2.8;
  const reference::Axes<double> ellipse = reference::ellipse_axes(domain.gradients);
  const Gradients<double> axes = axes_of(domain);
  const double heaviest = *std::ranges::max_element(pattern.weights);
  std::string svg = fmt::format("<svg viewBox=\"{} {} {} {}\">", -kAcross, -kUp, 2 * kAcross, 2 * kUp);
  for (std::size_t i = 0; i < pattern.probes.size(); ++i) {
    const Vector2<double> at = pattern.probes[i].u * axes.x + pattern.probes[i].v * axes.y;
    svg += fmt::format(
        "<circle cx=\"{:.3f}\" cy=\"{:.3f}\" r=\"{:.3f}\" fill=\"#667\" fill-opacity=\"{:.3f}\" stroke=\"#667\" "
        "stroke-width=\"0.03\"/>",
        at.u, -at.v, pattern.spacing * longer_gradient(domain) / 2, 0.65 * pattern.weights[i] / heaviest);
  }
  const auto arrow = [&](const Vector2<double>& axis, std::string_view colour) {
    svg +=
        fmt::format("<line x2=\"{:.3f}\" y2=\"{:.3f}\" stroke=\"{}\" stroke-width=\"0.07\"/>", axis.u, -axis.v, colour);
  };
  arrow(axes.x, "#d55e00");
  arrow(axes.y, "#0072b2");
  return svg + fmt::format(
                   "<ellipse rx=\"{:.3f}\" ry=\"{:.3f}\" transform=\"rotate({:.2f})\" fill=\"none\" "
                   "stroke=\"#000\" stroke-width=\"0.06\"/></svg>",
                   ellipse.major_radius, ellipse.minor_radius,
                   -std::atan2(ellipse.major.v, ellipse.major.u) * 180 / std::numbers::pi);
}

// From the Gaussian on the ellipse.
double shape_distance(const Domain& domain, const ProbePattern& pattern) {
  constexpr int kPerTexel = 2;
  const Gradients<double> texel_axes = axes_of(domain);
  const std::vector<double> alphas = reference::blend_alphas(pattern.weights);
  const auto filter = [&](const reference::MipMap& map, const Vector2<double>& texels) {
    const auto in_map = [&](const Gradients<double>& g) {
      return Gradients<double>{normalized(g.x, map.base()), normalized(g.y, map.base())};
    };
    reference::Cost cost;
    return vertex_based_filter(map, pattern, alphas, in_map(texel_axes),
                               {normalized(texels, map.base()), in_map(domain.gradients)}, cost);
  };
  const double level = std::log2(longer_gradient(domain) * pattern.spacing);
  const FilterShape shape =
      impulse_response(filter, MipFilter::kLanczos, std::max(static_cast<int>(std::ceil(level)), 0), kPerTexel);
  return distance(shape, gaussian_shape(domain.gradients, kPerTexel));
}

FigureOutput make_patterns(const FigureOptions& options) {
  const Gradients<double> turned = turned_screen(kPaperGradients);
  const std::array<Domain, 4> domains{{{"Ellipse", "ellipse", AxisSystem::kEllipse, kPaperGradients},
                                       {"Screen", "screen", AxisSystem::kScreen, kPaperGradients},
                                       {"Max", "max", AxisSystem::kMax, kPaperGradients},
                                       {"Screen, turned by 45°", "turned_screen", AxisSystem::kScreen, turned}}};
  struct Row {
    std::string label;
    std::string name;
    ProbePattern pattern;
  };
  const std::array<Row, 3> rows{{{"line of 4", "line_4", reference::line_pattern(4)},
                                 {"square of 4", "square_4", reference::square_pattern(2)},
                                 {"staggered 8", "staggered_8", reference::staggered_pattern()}}};
  const int side = std::max(options.size * 3 / 4, 2);
  page::Sheet sheet{"Sampling patterns in the footprint ellipse", {}, 4, side, side * 7 / 10, ""};
  nlohmann::ordered_json patterns;
  for (const Row& row : rows) {
    for (const Domain& domain : domains) {
      const double apart = shape_distance(domain, row.pattern);
      sheet.panels.push_back(
          {draw_pattern(domain, row.pattern), domain.label, fmt::format("{}, distance {:.2f}", row.label, apart)});
      patterns.push_back({{"system", domain.name}, {"pattern", row.name}, {"distance", apart}});
    }
  }
  sheet.caption =
      "After Olano, Mukherjee and Dorbie 2001, figure 4 and table 2: the footprint of Feline's figure 4 in black, "
      "probes in grey, as dark as they weigh, drawn half as wide as they are; axis 1 in red, axis 2 in blue. The same "
      "ellipse with the screen turned by 45 degrees, on the right, has gradients of equal length, and Max is Screen "
      "there. Distance: the part of the weight that is at other places than in an affine Gaussian on the ellipse.";
  return {page::to_svg(sheet), {{"patterns", patterns}}};
}

// What each probe has contributed to the frame after so many passes, read off by blending red, green and blue.
std::array<double, 3> run_passes(const std::array<double, 3>& weights, std::size_t passes) {
  const reference::MipMap map{{{3, 1, {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}}}, {}};
  ProbePattern pattern{{{-1, 0}, {0, 0}, {1, 0}}, {weights.begin(), weights.end()}, 1};
  std::vector<double> alphas = reference::blend_alphas(pattern.weights);
  pattern.probes.resize(passes);
  alphas.resize(passes);
  reference::Cost cost;
  const reference::Colour frame =
      vertex_based_filter(map, pattern, alphas, {{1.0 / 3, 0}, {0, 0}}, {{0.5, 0.5}, {}}, cost);
  return {frame[0], frame[1], frame[2]};
}

// As a fraction of small numbers where it is one.
std::string fraction(double value) {
  for (int below = 1; below <= 12; ++below) {
    const double above = std::round(value * below);
    if (std::abs(value * below - above) > 1e-9) continue;
    return below == 1 ? fmt::format("{:.0f}", above) : fmt::format("{:.0f}/{}", above, below);
  }
  return fmt::format("{:.6f}", value);
}

FigureOutput make_table(const FigureOptions& /*options*/) {
  const std::array<std::array<double, 3>, 2> cases{{{1.0 / 3, 1.0 / 3, 1.0 / 3}, {1.0 / 4, 1.0 / 2, 1.0 / 4}}};
  page::Table table{"Two cases for alpha blending three probes", {{"Probe"}}, {}};
  table.rows = {{{"Desired weights"}},
                {{"Rendering alpha"}},
                {{"Pass 1 contribution"}},
                {{"Pass 2 contribution"}},
                {{"Pass 3 contribution"}}};
  nlohmann::ordered_json all;
  for (const auto& weights : cases) {
    const std::vector<double> alphas = reference::blend_alphas(weights);
    std::array<std::array<double, 3>, 3> passes{};
    for (std::size_t pass = 0; pass < 3; ++pass) passes[pass] = run_passes(weights, pass + 1);
    for (std::size_t probe = 0; probe < 3; ++probe) {
      table.columns.push_back({std::to_string(probe + 1), true});
      table.rows[0].push_back({fraction(weights[probe])});
      table.rows[1].push_back({fraction(alphas[probe])});
      for (std::size_t pass = 0; pass < 3; ++pass) table.rows[2 + pass].push_back({fraction(passes[pass][probe])});
    }
    all.push_back({{"weights", weights}, {"alphas", alphas}, {"contributions", passes}});
  }
  const std::string words = page::paragraph(
      "After Olano, Mukherjee and Dorbie 2001, table 1. The rendering alpha applies to the new probe, 1 - alpha to all "
      "old ones. The alphas are the filter's own; the contributions were read off by running its passes on a red, a "
      "green and a blue texel.");
  return {page::document("Blending three probes", page::table(table) + words), {{"cases", all}}};
}

}  // namespace

std::vector<Figure> pattern_figures() {
  return {{"olano_4", "sampling patterns in the footprint ellipse, by system of axes", ".svg", make_patterns},
          {"olano_table_1", "alphas and contributions of blended probes", ".html", make_table}};
}

}  // namespace feline
