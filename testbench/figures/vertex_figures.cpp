// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "model/reference/vertex_based.h"
#include "testbench/figures/figure.h"
#include "testbench/figures/gallery.h"
#include "testbench/measure/render_rows.h"

namespace feline {
namespace {

using reference::AxisSystem;
using reference::ProbePattern;

Rendering render_pattern(const View& view, AxisSystem system, const ProbePattern& pattern) {
  const auto axes = interpolate_axes(view, system);
  const std::vector<double> alphas = reference::blend_alphas(pattern.weights);
  return render_rows(view, nullptr, [&](std::size_t i, reference::Cost& cost) {
    return vertex_based_filter(view.surface->images.lanczos, pattern, alphas, axes[i], view.pixels[i].lookup, cost);
  });
}

// A pattern whose probes are as wide as another one's.
ProbePattern with_spacing(ProbePattern pattern, double spacing) {
  pattern.spacing = spacing;
  return pattern;
}

struct Variant {
  std::string label;
  std::string name;      // of the pattern, or of another contestant
  ProbePattern pattern;  // no probes: that contestant
};

FigureOutput make_pictures(std::string_view scene, const std::string& title, const std::string& caption,
                           const std::vector<Variant>& variants, int size) {
  const Exhibition exhibition(scene, size);
  page::Sheet sheet{title, {}, 3, size, size, caption};
  nlohmann::ordered_json pictures;
  for (const Variant& variant : variants) {
    const Rendering rendering = variant.pattern.probes.empty()
                                    ? render_by(variant.name, exhibition.view())
                                    : render_pattern(exhibition.view(), AxisSystem::kMax, variant.pattern);
    sheet.panels.push_back(exhibition.panel(variant.label, rendering));
    pictures.push_back(exhibition.facts(variant.name, rendering));
  }
  sheet.panels.push_back(exhibition.truth_panel("What it ought to be"));
  return {page::to_svg(sheet), {{"pictures", pictures}}};
}

FigureOutput make_figure_1(const FigureOptions& options) {
  std::vector<Variant> variants{{"Mip mapping", "trilinear", {}}};
  for (const int probes : {2, 4, 8}) {
    variants.push_back(
        {fmt::format("{} samples", probes), fmt::format("line_{}", probes), reference::line_pattern(probes)});
  }
  variants.push_back({"Mip-mapped EWA", "ewa", {}});
  return make_pictures("runway", "A runway with mip mapping and vertex-based anisotropic texturing",
                       "After Olano, Mukherjee and Dorbie 2001, figure 1, and EWA beside it: mip mapping, and two, "
                       "four and eight samples along the longer gradient (the Max system), computed at vertices. The "
                       "error is the root mean square difference, channels of 0 to 1, from a Gaussian pixel filter "
                       "projected point by point.",
                       variants, options.size);
}

FigureOutput make_figure_5(const FigureOptions& options) {
  const ProbePattern line = reference::line_pattern(8);
  const ProbePattern staggered = reference::staggered_pattern();
  return make_pictures(
      "tessellated", "Effect of sampling pattern and mip bias",
      fmt::format(
          "After Olano, Mukherjee and Dorbie 2001, figure 5: eight probes on the longer gradient or over the "
          "whole footprint (figure 4f), Max system, computed at the vertices of large polygons. Small probes "
          "are {:.2f} of the longer gradient wide (a bias of {:.2f} levels), large ones {:.2f} ({:.2f} levels). "
          "The error is the root mean square difference, channels of 0 to 1, from a Gaussian pixel filter "
          "projected point by point.",
          line.spacing, std::log2(line.spacing), staggered.spacing, std::log2(staggered.spacing)),
      {{"a. Mip mapping", "trilinear", {}},
       {"b. On the axis, right size", "line_8", line},
       {"c. Whole footprint, too small", "staggered_small", with_spacing(staggered, line.spacing)},
       {"d. On the axis, too large", "line_8_large", with_spacing(line, staggered.spacing)},
       {"e. Whole footprint, right size", "staggered", staggered}},
      options.size);
}

}  // namespace

std::vector<Figure> vertex_figures() {
  return {
      {"olano_1", "a runway with mip mapping and vertex-based texturing of 2, 4 and 8 samples", ".svg", make_figure_1},
      {"olano_5", "effect of sampling pattern and mip bias", ".svg", make_figure_5}};
}

}  // namespace feline
