// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "testbench/figures/figure.h"
#include "testbench/figures/gallery.h"

namespace feline {
namespace {

struct Shown {
  std::string label;
  std::string contestant;  // the truth where empty
};

const Shown kTruth{"What it ought to be", ""};
const std::string kSimpleEfficient = "feline_simple_high_efficiency_gaussian";
const std::string kSimpleQuality = "feline_simple_high_quality_gaussian";
const std::string kTableQuality = "feline_table_high_quality_gaussian";

constexpr std::string_view kMeasure =
    " Simple Feline has Gaussian probes and the report's parameters. Cycles are those of hardware that reads eight "
    "texels in one. The error is the root mean square difference, channels of 0 to 1, from a Gaussian pixel filter "
    "projected point by point over the texels of level 0, which is shown, too; it is not in the report.";

// One scene by several filters.
struct SideBySide {
  std::string name;
  std::string title;
  std::string scene;
  std::string caption;
  std::vector<Shown> shown;
  int magnification = 1;  // shows the square in which trilinear filtering fails most
};

FigureOutput make_side_by_side(const SideBySide& figure, const FigureOptions& options) {
  Exhibition exhibition(figure.scene, options.size);
  if (figure.magnification > 1) {
    exhibition.show(find_detail(render_by("trilinear", exhibition.view()).picture, exhibition.truth().gaussian,
                                std::max(options.size / figure.magnification, 1)));
  }
  page::Sheet sheet{figure.title, {}, 3, options.size, options.size, figure.caption + std::string(kMeasure)};
  nlohmann::ordered_json pictures;
  for (const Shown& shown : figure.shown) {
    if (shown.contestant.empty()) {
      sheet.panels.push_back(exhibition.truth_panel(shown.label));
      continue;
    }
    const Rendering rendering = render_by(shown.contestant, exhibition.view());
    sheet.panels.push_back(exhibition.panel(shown.label, rendering));
    pictures.push_back(exhibition.facts(shown.contestant, rendering));
  }
  return {page::to_svg(sheet), {{"truth_error", exhibition.truth().gaussian_error}, {"pictures", pictures}}};
}

const std::vector<SideBySide>& side_by_sides() {
  static const std::vector<SideBySide> all{
      {"feline_18_22",
       "Curved lines",
       "curves",
       "After WRL 99/1, figures 18 to 22: a pattern of curved lines.",
       {{"18. Trilinear", "trilinear"},
        {"19. Texram", "texram"},
        {"20. Simple Feline, high efficiency", kSimpleEfficient},
        {"21. Simple Feline, high quality", kSimpleQuality},
        {"22. Mip-mapped EWA", "ewa"},
        kTruth}},
      {"feline_23_26",
       "A floor of bricks",
       "bricks",
       "After WRL 99/1, figures 23 to 26, and trilinear filtering beside them: a floor of bricks.",
       {{"Trilinear", "trilinear"},
        {"23. Texram", "texram"},
        {"24. Simple Feline, high efficiency", kSimpleEfficient},
        {"25. Simple Feline, high quality", kSimpleQuality},
        {"26. Mip-mapped EWA", "ewa"},
        kTruth}},
      {"feline_27_30",
       "Magnified texture-mapped text",
       "text",
       "After WRL 99/1, figures 27 to 30, and the high-quality parameters beside them: text, the square in which "
       "trilinear filtering fails most, magnified; cycles and errors are of the whole picture.",
       {{"27. Trilinear", "trilinear"},
        {"28. Texram", "texram"},
        {"29. Simple Feline, high efficiency", kSimpleEfficient},
        {"Simple Feline, high quality", kSimpleQuality},
        {"30. Mip-mapped EWA", "ewa"},
        kTruth},
       3}};
  return all;
}

// The extreme projections: light through a window on a hollow wall, and a mirror.
constexpr std::array<std::string_view, 2> kExtremeScenes{"window", "reflector"};

FigureOutput make_extreme_pictures(const FigureOptions& options) {
  page::Sheet sheet{
      "Highly distorted perspective projections",
      {},
      3,
      options.size,
      options.size,
      "After WRL 99/1, figures 31 and 32: Simple Feline blurs where the gradients of a pixel are nearly "
      "parallel, Table Feline does not. Above: light of a window on a hollow wall; below: a mirror sheet, "
      "environment-mapped. High-quality parameters, Gaussian probes. The error is the root mean square "
      "difference, channels of 0 to 1, from a Gaussian pixel filter projected point by point."};
  nlohmann::ordered_json pictures;
  for (const std::string_view scene : kExtremeScenes) {
    const Exhibition exhibition(scene, options.size);
    const std::array<Shown, 2> both{{{"31. Simple Feline", kSimpleQuality}, {"32. Table Feline", kTableQuality}}};
    for (const Shown& shown : both) {
      const Rendering rendering = render_by(shown.contestant, exhibition.view());
      sheet.panels.push_back(exhibition.panel(shown.label, rendering));
      pictures.push_back(exhibition.facts(shown.contestant, rendering));
    }
    sheet.panels.push_back(exhibition.truth_panel(kTruth.label));
  }
  return {page::to_svg(sheet), {{"pictures", pictures}}};
}

// How the pixels spread over probe counts, in parts of all.
nlohmann::ordered_json probe_counts(const std::vector<float>& probes) {
  std::vector<double> parts(17);
  for (const float count : probes) parts[static_cast<std::size_t>(count)] += 1.0 / static_cast<double>(probes.size());
  nlohmann::ordered_json json;
  for (std::size_t count = 1; count < parts.size(); ++count) {
    if (parts[count] > 0) json[std::to_string(count)] = parts[count];
  }
  return json;
}

FigureOutput make_probe_maps(const FigureOptions& options) {
  page::Sheet sheet{"Probes a pixel", {}, 2, options.size, options.size, ""};
  sheet.caption =
      "After WRL 99/1, figures 33 and 34: the probes that each pixel of figures 31 and 32 took. White 1, light blue 2, "
      "dark blue 4, green 8, red 16, blended between.";
  nlohmann::ordered_json maps;
  for (const std::string_view scene : kExtremeScenes) {
    const Exhibition exhibition(scene, options.size);
    const std::array<Shown, 2> both{{{"33. Simple Feline", kSimpleQuality}, {"34. Table Feline", kTableQuality}}};
    for (const Shown& shown : both) {
      const Rendering rendering = render_by(shown.contestant, exhibition.view());
      sheet.panels.push_back(exhibition.probes_panel(shown.label, rendering));
      nlohmann::ordered_json facts = exhibition.costs(shown.contestant, rendering);
      facts["most_probes"] = *std::ranges::max_element(rendering.probes);
      facts["parts"] = probe_counts(rendering.probes);
      maps.push_back(std::move(facts));
    }
  }
  return {page::to_svg(sheet), {{"maps", maps}}};
}

}  // namespace

std::vector<Figure> picture_figures() {
  const std::array<std::string_view, 3> descriptions{"curved lines by five filters, side by side",
                                                     "a floor of bricks by five filters, side by side",
                                                     "magnified text by five filters, side by side"};
  std::vector<Figure> all;
  for (std::size_t i = 0; i < side_by_sides().size(); ++i) {
    const SideBySide& figure = side_by_sides()[i];
    all.push_back({figure.name, std::string(descriptions[i]), ".svg",
                   [&figure](const FigureOptions& options) { return make_side_by_side(figure, options); }});
  }
  all.push_back({"feline_31_32", "Simple and Table Feline on highly distorted projections, side by side", ".svg",
                 make_extreme_pictures});
  all.push_back({"feline_33_34", "probe-count maps of the same", ".svg", make_probe_maps});
  return all;
}

}  // namespace feline
