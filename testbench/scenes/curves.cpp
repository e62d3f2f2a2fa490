// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/ground.h"
#include "testbench/scenes/paint.h"

namespace feline {
namespace {

constexpr int kSize = 1024;
constexpr Colour kPaper = {0.97, 0.96, 0.92};
constexpr std::array<Colour, 5> kInks = {
    {{0.10, 0.14, 0.36}, {0.05, 0.39, 0.50}, {0.42, 0.12, 0.40}, {0.80, 0.28, 0.16}, {0.12, 0.12, 0.14}}};

// Concentric arcs that crowd together outwards (a chirp): 39 texels apart in the middle, 8 in
// the corners. Symmetric about the middle, so that the tiles meet.
Colour curve_at(double u, double v) {
  const double x = (u - kSize / 2.0) / kSize;
  const double y = (v - kSize / 2.0) / kSize;
  const double radius = std::sqrt(x * x + y * y);
  const double phase = 26.0 * radius + 70.0 * radius * radius;  // in lines
  const double pitch = (26.0 + 140.0 * radius) / kSize;         // lines a texel
  const double turn = std::floor(phase);
  const double from_line = std::abs(phase - turn - 0.5);  // 0 on the line, 1/2 between
  const auto ink = static_cast<std::size_t>(turn / 4.0) % kInks.size();
  return mix(kInks[ink], kPaper, smooth_step(0.22, 0.5 * pitch, from_line));
}

TexturePoint project_curves(const Dual& x, const Dual& y) {
  constexpr GroundView kView = {.top = 0.10,
                                .bottom = 0.80,
                                .width = 0.7,
                                .cosine = 24.0 / 25.0,
                                .sine = 7.0 / 25.0,
                                .scale = 0.55,
                                .s_offset = 0.05,
                                .t_offset = 1.9};
  return ground_point(kView, x, y);
}

}  // namespace

MipLevel paint_curves() { return paint_rgba(kSize, kSize, curve_at); }

Scene curves_scene() {
  return {"curves",
          "concentric arcs of rising frequency on a tilted plane (paper, figures 18-22)",
          TexelFormat::kRgba8,
          false,
          paint_curves,
          project_curves};
}

}  // namespace feline
