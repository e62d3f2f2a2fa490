// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/ground.h"
#include "testbench/scenes/paint.h"

namespace feline {
namespace {

constexpr int kSize = 64;
constexpr double kHalf = kSize / 2.0;
constexpr Colour kGlaze = {0.95, 0.93, 0.86};
constexpr Colour kCobalt = {0.08, 0.20, 0.50};
constexpr Colour kOchre = {0.88, 0.60, 0.14};
constexpr Colour kBrickRed = {0.70, 0.22, 0.14};
constexpr Colour kGrout = {0.42, 0.40, 0.38};

// 1 inside, 0 outside, from the distance to the outline in texels, positive inside.
double inside(double distance) { return smooth_step(0.0, 0.6, distance); }

// A glazed tile: a star of eight points in the middle, and a quarter of a rosette in each corner that
// the neighbours complete.
Colour tile_at(double u, double v) {
  const double x = std::abs(u - kHalf);
  const double y = std::abs(v - kHalf);
  const double square = x > y ? x : y;
  const double diamond = (x + y) * 0.70710678118654752;
  const double inner = square < diamond ? square : diamond;
  const double radius = std::sqrt((kHalf - x) * (kHalf - x) + (kHalf - y) * (kHalf - y));  // about the corner
  const double middle = std::sqrt(x * x + y * y);

  Colour colour = mix(kGlaze, kCobalt, inside(17.5 - inner));  // the star is the union of two squares
  colour = mix(colour, kGlaze, inside(14.5 - inner));
  colour = mix(colour, kOchre, inside(12.0 - inner));
  colour = mix(colour, kBrickRed, inside(6.0 - middle));
  colour = mix(colour, kCobalt, inside(21.0 - radius));
  colour = mix(colour, kGlaze, inside(16.0 - radius));
  colour = mix(colour, (u < kHalf) == (v < kHalf) ? kBrickRed : kOchre, inside(12.5 - radius));
  return mix(colour, kGrout, inside(square - kHalf + 1.2));
}

MipLevel paint_tile() { return paint_rgba(kSize, kSize, tile_at); }

// At 512 x 512 a texel of the lower edge is a pixel wide, and a pixel of the upper edge is a repeat
// wide: the slopes are 1 to 83. The middle of the range of s and t is at 0, which spares float32 a bit.
TexturePoint project_repeat(const Dual& x, const Dual& y) {
  constexpr GroundView kView = {.top = 0.0145,
                                .bottom = 1.2,
                                .width = 1.1855,
                                .cosine = 15.0 / 17.0,
                                .sine = 8.0 / 17.0,
                                .scale = 8.0,
                                .s_offset = -260.0,
                                .t_offset = 320.0};
  return ground_point(kView, x, y);
}

}  // namespace

Scene repeat_scene() {
  return {"repeat",
          "a tile of 64 x 64 texels, repeated until a pixel holds more than one whole tile; sRGB",
          TexelFormat::kRgba8,
          true,
          paint_tile,
          project_repeat};
}

}  // namespace feline
