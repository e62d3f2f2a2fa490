// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/paint.h"

namespace feline {
namespace {

// What a mirror ball in a town's square shows: a sphere map (reflector.cpp), the inside of a disc as wide
// as the texture.

constexpr int kSize = 1024;
constexpr int kPeriod = 4096;      // of noise: none of it comes round
constexpr double kShift = 1024.0;  // makes its coordinates positive

struct Direction {
  double x;
  double y;  // upwards
  double z;  // towards the viewer
};

constexpr Direction kSun = {0.48, 0.60, 0.64};

constexpr std::array<Colour, 5> kFacades = {
    {{0.76, 0.58, 0.43}, {0.64, 0.33, 0.26}, {0.84, 0.78, 0.66}, {0.50, 0.52, 0.56}, {0.88, 0.68, 0.36}}};
constexpr Colour kRoof = {0.46, 0.23, 0.17};
constexpr Colour kPane = {0.16, 0.22, 0.30};

double noise_at(double x, double y, int seed) { return fractal_noise(x + kShift, y + kShift, kPeriod, seed); }

Colour sky(const Direction& d) {
  const double rise = 1.0 - d.y;
  const Colour blue = mix({0.16, 0.38, 0.74}, {0.70, 0.82, 0.92}, rise * rise);
  // Clouds lie in a plane above.
  const double reach = 1.0 / (d.y + 0.14);
  const double x = d.x * reach;
  const double z = d.z * reach;
  const double bulk = noise_at(1.7 * x, 1.7 * z, 71);
  const double wisp = noise_at(11.0 * x, 11.0 * z, 74);
  const double cover = smooth_step(0.52, 0.12, 0.7 * bulk + 0.3 * wisp);
  const double belly = smooth_step(0.62, 0.2, bulk);
  const Colour cloud = mix({1.0, 0.99, 0.97}, {0.66, 0.70, 0.78}, 0.8 * belly * wisp + 0.2 * belly);
  const double off_sun = 1.0 - (d.x * kSun.x + d.y * kSun.y + d.z * kSun.z);
  const double glow = 0.012 / (off_sun + 0.012);
  const Colour lit = mix(mix(blue, cloud, cover), {1.0, 0.95, 0.80}, 0.8 * glow);
  return mix(lit, {1.0, 0.99, 0.92}, 1.0 - smooth_step(0.0035, 0.0006, off_sun));
}

// Once around the horizon: 0 to 4, an angle's stand-in that needs no arc tangent.
double bearing(const Direction& d) {
  const double turn = d.x / (std::abs(d.x) + std::abs(d.z));
  return d.z > 0 ? 1.0 + turn : 3.0 - turn;
}

// One house of a row: across is 0 to 1 along its front, up the tangent of the elevation.
Colour facade(int house, double across, double up) {
  constexpr double kStorey = 0.052;
  constexpr int kWindows = 5;
  const auto pick = static_cast<std::size_t>(hash01(house, 0, 81) * kFacades.size());
  const double tone = 0.85 + 0.3 * hash01(house, 0, 82);
  const double column = across * kWindows;
  const double storey = up / kStorey;
  const double pane_x = std::abs(column - std::floor(column) - 0.5);
  const double pane_y = std::abs(storey - std::floor(storey) - 0.5);
  const int cell = static_cast<int>(column) + kWindows * static_cast<int>(storey);
  Colour colour = tone * kFacades[pick];
  if (pane_y > 0.44) colour = 0.8 * colour;  // a ledge under each storey
  if (pane_x < 0.33 && pane_y < 0.36) colour = Colour{0.96, 0.95, 0.92};
  if (pane_x < 0.26 && pane_y < 0.30 && pane_x > 0.03) {
    colour = hash01(cell, house, 83) < 0.25 ? Colour{0.99, 0.86, 0.52} : (0.7 + 0.6 * hash01(cell, house, 84)) * kPane;
  }
  return colour;
}

Colour roof(int house, double across, double up) {
  const int course = static_cast<int>(up * 110.0);
  const int tile = static_cast<int>(across * 14.0 + 0.5 * (course % 2));
  return (0.7 + 0.6 * hash01(tile, course, 85 + house)) * kRoof;
}

// Houses, and trees before them; where there is neither, the sky.
Colour horizon(const Direction& d) {
  constexpr int kHouses = 44;
  constexpr double kHighest = 0.6;  // of all roofs
  const double up = d.y / std::sqrt(d.x * d.x + d.z * d.z);
  if (up > kHighest) return sky(d);
  const double around = bearing(d) / 4.0;
  const double leaf = noise_at(700.0 * around, 90.0 * up, 91);
  const double crown = noise_at(60.0 * around, 0.5, 94);
  if (up < 0.34 * (crown - 0.42) + 0.05 * leaf) {
    return (0.35 + 1.1 * leaf) * mix({0.16, 0.32, 0.10}, {0.42, 0.50, 0.14}, noise_at(60.0 * around, 12.0 * up, 97));
  }
  const double along = around * kHouses;
  const int house = static_cast<int>(along);
  const double across = along - house;
  const double height = 0.21 + 0.26 * hash01(house, 0, 80);
  const double gable = 0.07 * (1.0 - 2.0 * std::abs(across - 0.5));  // a pitched roof
  if (up < height) return facade(house, across, up);
  return up < height + gable ? roof(house, across, up) : sky(d);
}

// A round square of tiles a unit below, ringed by stone, on a lawn.
Colour ground(const Direction& d) {
  constexpr double kTile = 0.32;
  constexpr double kRadius = 4.6;
  const double x = d.x / -d.y;
  const double z = d.z / -d.y;
  const double away = std::sqrt(x * x + z * z);
  if (away > kRadius) {
    if (away < kRadius + 0.8) return {0.74, 0.71, 0.65};
    const double far = clamp01(away / 40.0);
    const double blade = noise_at(9.0 * d.x / (0.1 - d.y), 9.0 * d.z / (0.1 - d.y), 101);
    return (0.7 + 0.6 * blade) * mix({0.30, 0.47, 0.16}, {0.46, 0.56, 0.26}, far);
  }
  const double column = std::floor(x / kTile);
  const double row = std::floor(z / kTile);
  const double from_x = std::abs(x / kTile - column - 0.5);
  const double from_z = std::abs(z / kTile - row - 0.5);
  const int i = static_cast<int>(column);
  const int j = static_cast<int>(row);
  const double grain = 0.8 + 0.4 * noise_at(16.0 * x, 16.0 * z, 104);
  const Colour tile = (i + j) % 2 == 0 ? Colour{0.86, 0.80, 0.69} : Colour{0.56, 0.25, 0.19};
  const Colour worn = (grain * (0.88 + 0.24 * hash01(i + 100, j + 100, 107))) * tile;
  if (from_x + from_z < 0.2) return (grain * 0.9) * Colour{0.20, 0.30, 0.42};  // an inlaid lozenge
  return from_x > 0.465 || from_z > 0.465 ? Colour{0.30, 0.28, 0.26} : worn;
}

Colour look(double u, double v) {
  const double x = 2.0 * u / kSize - 1.0;
  const double y = 1.0 - 2.0 * v / kSize;
  const double square = x * x + y * y;
  if (square > 0.998) return {0.36, 0.44, 0.22};  // all of the rim shows one direction, straight behind
  const double facing = std::sqrt(1.0 - square);
  const Direction d = {2.0 * facing * x, 2.0 * facing * y, 2.0 * facing * facing - 1.0};
  return d.y > 0 ? horizon(d) : ground(d);
}

// Four samples a texel: the texture itself is not to flicker.
Colour environment_at(double u, double v) {
  constexpr double kOff = 0.25;
  return 0.25 *
         (look(u - kOff, v - kOff) + look(u + kOff, v - kOff) + look(u - kOff, v + kOff) + look(u + kOff, v + kOff));
}

}  // namespace

MipLevel paint_environment() { return paint_rgba(kSize, kSize, environment_at); }

}  // namespace feline
