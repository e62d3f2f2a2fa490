// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/ground.h"
#include "testbench/scenes/paint.h"

namespace feline {
namespace {

constexpr int kSize = 1024;
constexpr int kColumns = 8;
constexpr int kRows = 16;
constexpr double kBrickWidth = 1.0 * kSize / kColumns;
constexpr double kBrickHeight = 1.0 * kSize / kRows;

constexpr std::array<Colour, 6> kClay = {{{0.66, 0.29, 0.20},
                                          {0.73, 0.37, 0.24},
                                          {0.58, 0.23, 0.18},
                                          {0.78, 0.46, 0.30},
                                          {0.50, 0.25, 0.22},
                                          {0.69, 0.33, 0.19}}};
constexpr Colour kMortar = {0.71, 0.68, 0.62};

// Texels from the point to the outline of the brick around it, positive inside; corners are round.
double inside_brick(double x, double y) {
  constexpr double kCorner = 7.0;
  constexpr double kJoint = 4.5;  // half of the mortar between two bricks
  const double over_x = std::abs(x) - (kBrickWidth / 2 - kJoint - kCorner);
  const double over_y = std::abs(y) - (kBrickHeight / 2 - kJoint - kCorner);
  const double out_x = over_x > 0 ? over_x : 0;
  const double out_y = over_y > 0 ? over_y : 0;
  const double deepest = over_x > over_y ? over_x : over_y;
  return kCorner - std::sqrt(out_x * out_x + out_y * out_y) - (deepest < 0 ? deepest : 0);
}

Colour brick_at(double u, double v) {
  const double chip = 5.0 * (fractal_noise(u / 16, v / 16, kSize / 16, 11) - 0.5);
  const int row = static_cast<int>(v / kBrickHeight);
  const double shifted = u + (row % 2 == 0 ? 0.0 : kBrickWidth / 2);
  const int column = static_cast<int>(shifted / kBrickWidth);
  const double x = shifted - (column + 0.5) * kBrickWidth;
  const double y = v - (row + 0.5) * kBrickHeight;
  const double inside = inside_brick(x, y) + chip;

  const int brick = column % kColumns;
  const auto clay = static_cast<std::size_t>(hash01(brick, row, 1) * kClay.size());
  const double tone = 0.86 + 0.28 * hash01(brick, row, 2);
  const double grain = 0.78 + 0.44 * fractal_noise(u / 8, v / 8, kSize / 8, 21 + static_cast<int>(clay));
  // Light from the upper left on rounded edges.
  const double rim = 1.0 - clamp01(inside / 9.0);
  const double facing = (x < 0 ? 0.5 : -0.5) * std::abs(x) / kBrickWidth + (y < 0 ? 0.5 : -0.5);
  const Colour clay_colour = (tone * grain * (1.0 + 0.35 * rim * facing)) * kClay[clay];

  const double shade = 0.62 + 0.38 * clamp01(-inside / 4.0);  // joints are darkest at the brick
  const Colour mortar = (shade * (0.8 + 0.4 * fractal_noise(u / 4, v / 4, kSize / 4, 31))) * kMortar;
  return mix(mortar, clay_colour, smooth_step(0.0, 1.0, inside));
}

TexturePoint project_bricks(const Dual& x, const Dual& y) {
  constexpr GroundView kView = {.top = 0.055,
                                .bottom = 0.855,
                                .width = 0.8,
                                .cosine = 12.0 / 13.0,
                                .sine = 5.0 / 13.0,
                                .scale = 0.62,
                                .s_offset = 0.15,
                                .t_offset = 0.4};
  return ground_point(kView, x, y);
}

}  // namespace

MipLevel paint_bricks() { return paint_rgba(kSize, kSize, brick_at); }

Scene bricks_scene() {
  return {"bricks",
          "a floor of bricks up to just below the horizon, turned; sRGB",
          TexelFormat::kRgba8,
          true,
          paint_bricks,
          project_bricks};
}

}  // namespace feline
