// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/ground.h"
#include "testbench/scenes/paint.h"

namespace feline {
namespace {

constexpr int kSize = 512;
constexpr int kCells = 8;
constexpr double kCell = 1.0 * kSize / kCells;
constexpr Colour kLight = {0.94, 0.92, 0.86};
constexpr std::array<Colour, 4> kDark = {
    {{0.10, 0.24, 0.38}, {0.12, 0.36, 0.36}, {0.45, 0.16, 0.20}, {0.20, 0.17, 0.30}}};

// Marble squares; edges fall between texels, so that they are as hard as a texture can be.
Colour square_at(double u, double v) {
  const int column = static_cast<int>(u / kCell);
  const int row = static_cast<int>(v / kCell);
  const double cloud = fractal_noise(u / 32, v / 32, kSize / 32, 41);
  const double vein = std::abs(cloud - 0.5) * 12.0;
  const double veining = 1.0 - clamp01(vein);
  if ((column + row) % 2 == 0) return (1.0 - 0.16 * veining) * kLight;
  const auto pick = static_cast<std::size_t>(hash01(column, row, 42) * kDark.size());
  return mix((0.85 + 0.3 * cloud) * kDark[pick], kLight, 0.3 * veining);
}

TexturePoint project_checkerboard(const Dual& x, const Dual& y) {
  constexpr GroundView kView = {.top = 0.06,
                                .bottom = 0.86,
                                .width = 0.8,
                                .cosine = 4.0 / 5.0,
                                .sine = 3.0 / 5.0,
                                .scale = 0.55,
                                .s_offset = 0.2,
                                .t_offset = 0.3};
  return ground_point(kView, x, y);
}

}  // namespace

MipLevel paint_checkerboard() { return paint_rgba(kSize, kSize, square_at); }

Scene checkerboard_scene() {
  return {"checkerboard",      "a marble checkerboard up to just below the horizon, turned",
          TexelFormat::kRgba8, false,
          paint_checkerboard,  project_checkerboard};
}

}  // namespace feline
