// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>

#include "testbench/figures/figure.h"
#include "testbench/figures/viewing_angles.h"
#include "testbench/page/plot.h"
#include "testbench/page/sheet.h"

namespace feline {
namespace {

constexpr int kLastAngle = 85;
constexpr int kAngleStep = 5;

FigureOutput make_costs(const FigureOptions& /*options*/) {
  page::Plot plot{"feline_35",
                  "Cycles a pixel at increasingly oblique viewing angles",
                  {"viewing angle, degrees", false, 0, 90},
                  {"cycles a pixel", false, 0, 0},
                  {{"Realistic EWA"},
                   {"Optimistic EWA"},
                   {"Simple Feline, high quality"},
                   {"Simple Feline, high efficiency"},
                   {"Texram"},
                   {"trilinear"}},
                  860,
                  480};
  nlohmann::ordered_json angles;
  AngleCosts first;
  AngleCosts last;
  for (int degrees = 0; degrees <= kLastAngle; degrees += kAngleStep) {
    const AngleCosts costs = measure_costs(degrees);
    const std::array<double, 6> cycles{costs.ewa.stamp_cycles,       costs.ewa.cycles,    costs.high_quality.cycles,
                                       costs.high_efficiency.cycles, costs.texram.cycles, costs.trilinear.cycles};
    for (std::size_t i = 0; i < cycles.size(); ++i) plot.series[i].points.push_back({double(degrees), cycles[i]});
    angles.push_back({{"degrees", degrees},
                      {"trilinear", cycles[5]},
                      {"texram", cycles[4]},
                      {"feline_high_efficiency", cycles[3]},
                      {"feline_high_quality", cycles[2]},
                      {"optimistic_ewa", cycles[1]},
                      {"realistic_ewa", cycles[0]},
                      {"ewa_texels", costs.ewa.texels},
                      {"stamp_texels_outside", costs.stamp_texels_outside()}});
    if (degrees == 0) first = costs;
    last = costs;
  }
  const std::string caption = fmt::format(
      "After WRL 99/1, figure 35. A plane seen by a camera with a field of view of 4.8 degrees, at 0 degrees along its "
      "normal; means over viewing distances, evenly spread on a logarithmic scale over the octave after which mip "
      "levels repeat, and over turns of the texture. A probe takes one cycle. Optimistic EWA reads eight texels of the "
      "ellipse in each cycle but the last; Realistic EWA a stamp of 4 x 2 or 2 x 4 texels, of which {:.1f} lie outside "
      "the ellipse at 0 degrees and {:.1f} at {} degrees. EWA widens ellipses more than 16 times as long as wide; "
      "probes are limited to 16.",
      first.stamp_texels_outside(), last.stamp_texels_outside(), kLastAngle);
  return {page::to_svg({plot.title, {{page::svg(plot), "", ""}}, 1, plot.width, plot.height, caption}),
          {{"stamp_texels_outside_near_circles", first.stamp_texels_outside()},
           {"stamp_texels_outside_eccentric", last.stamp_texels_outside()},
           {"angles", angles}}};
}

}  // namespace

std::vector<Figure> cost_figures() {
  return {
      {"feline_35", "cycles a pixel against viewing angle, of trilinear, Texram, Feline and EWA", ".svg", make_costs}};
}

}  // namespace feline
