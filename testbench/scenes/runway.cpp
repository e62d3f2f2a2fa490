// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string_view>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/font.h"
#include "testbench/scenes/paint.h"
#include "testbench/scenes/perspective.h"

namespace feline {
namespace {

// After SGI's runway demo ("Anisotropic", papers/rip-mapping-demo.txt): markings along the line of
// sight, which isotropic filtering loses first.

constexpr int kSize = 1024;
constexpr double kCentre = kSize / 2.0;
constexpr double kHalfWidth = 116.0;  // of the asphalt, texels
constexpr Colour kPaint = {0.95, 0.95, 0.92};

// 1 inside [from, to] along one axis, 0 outside, with edges a texel wide.
double band(double value, double from, double to) {
  return smooth_step(from, 0.5, value) * (1.0 - smooth_step(to, 0.5, value));
}

// The number at the threshold: a glyph as wide and high as given, upper left at (left, top).
double numeral(char digit, double x, double y, double left, double top, double dot_x, double dot_y) {
  const double column = std::floor((x - left) / dot_x);
  const double row = std::floor((y - top) / dot_y);
  if (column < 0 || column >= kGlyphWidth || row < 0 || row >= kGlyphHeight) return 0.0;
  const int bits = glyph(digit)[static_cast<std::size_t>(row)];
  return bits >> (kGlyphWidth - 1 - static_cast<int>(column)) & 1;
}

// x from the centre line, y along it, both in texels: 1 where there is paint.
double marking(double x, double y) {
  const double side = std::abs(x);
  const double edge = band(side, kHalfWidth - 12, kHalfWidth - 6);
  const double dash = y < 560 && std::fmod(y, 112.0) < 64 ? band(side, -1, 3) : 0.0;
  const double key = side > 6 && side < 98 && std::fmod(side - 6, 16.0) < 10 ? 1.0 : 0.0;
  const double threshold = key * band(y, 850, 990);
  const double number = numeral('0', x, y, -62, 690, 10, 14) + numeral('9', x, y, 12, 690, 10, 14);
  const double touchdown = band(side, 40, 62) * band(y, 300, 400);
  return clamp01(edge + dash + threshold + number + touchdown);
}

Colour runway_at(double u, double v) {
  const double x = u - kCentre;
  const double side = std::abs(x);
  const double patch = fractal_noise(u / 32, v / 32, kSize / 32, 51);
  const double blade = fractal_noise(u / 4, v / 4, kSize / 4, 54);
  const double mown = std::floor(u / 64.0 - 2.0 * std::floor(u / 128.0)) == 0 ? 0.04 : -0.04;
  const Colour meadow = mix({0.24, 0.37, 0.13}, {0.45, 0.53, 0.22}, patch + mown);
  const Colour grass = (0.75 + 0.5 * blade) * meadow;
  const Colour asphalt = (0.85 + 0.3 * blade) * Colour{0.27 + 0.05 * patch, 0.27 + 0.05 * patch, 0.29 + 0.05 * patch};
  // Rubber where wheels touch down.
  const double rubber = band(side, 10, 44) * band(v, 180, 640) * patch;
  const Colour strip = mix((1.0 - 0.6 * rubber) * asphalt, kPaint, 0.92 * marking(x, v));
  // A yellow-edged taxiway runs along.
  const double taxi = std::abs(side - 300.0);
  const Colour taxiway = mix(asphalt, {0.93, 0.74, 0.16}, band(taxi, -1, 3) + band(taxi, 30, 34));
  const Colour beside = mix(grass, taxiway, band(taxi, -1, 40));
  return mix(beside, strip, 1.0 - smooth_step(kHalfWidth, 1.0, side));
}

MipLevel paint_runway() { return paint_rgba(kSize, kSize, runway_at); }

// A camera at height 1 looks ahead over a picture from slope top to slope bottom below the horizon.
// The airfield is one rectangle in front of it, which reaches beyond the picture on all sides.
struct RunwayView {
  double top;
  double bottom;  // bottom - top is the picture's height, and its width
  double near;
  double far;
  double side;   // half of the rectangle's width
  double tile;   // units a texture repeat
  double begin;  // t below the camera

  constexpr Vertex vertex(double aside, double ahead) const {
    const double extent = bottom - top;
    return {0.5 + aside / (ahead * extent), (1.0 / ahead - top) / extent, ahead, 0.5 + aside / tile,
            begin - ahead / tile};
  }
};

template <RunwayView kView>
TexturePoint project_runway(const Dual& x, const Dual& y) {
  constexpr Vertex kNearLeft = kView.vertex(-kView.side, kView.near);
  constexpr Vertex kNearRight = kView.vertex(kView.side, kView.near);
  constexpr Vertex kFarLeft = kView.vertex(-kView.side, kView.far);
  constexpr Vertex kFarRight = kView.vertex(kView.side, kView.far);
  static constexpr PerspectiveTriangle kLeft({kNearLeft, kNearRight, kFarLeft});
  static constexpr PerspectiveTriangle kRight({kNearRight, kFarRight, kFarLeft});
  return (kLeft.covers(x.value, y.value) ? kLeft : kRight).interpolate(x, y);
}

// A pixel's footprint is 1 / slope times as long as it is wide: the pitch of the line of sight decides.
constexpr RunwayView kSteep = {
    .top = 0.465, .bottom = 1.165, .near = 0.8, .far = 2.3, .side = 0.9, .tile = 1.2, .begin = 1.82};
constexpr RunwayView kMiddle = {
    .top = 0.18, .bottom = 0.88, .near = 1.1, .far = 5.8, .side = 2.2, .tile = 2.4, .begin = 1.5};
constexpr RunwayView kShallow = {
    .top = 0.06, .bottom = 0.76, .near = 1.3, .far = 17.0, .side = 6.5, .tile = 5.0, .begin = 1.3};
constexpr RunwayView kLow = {
    .top = 0.0375, .bottom = 0.3875, .near = 2.5, .far = 28.0, .side = 5.2, .tile = 5.0, .begin = 1.4};

template <RunwayView kView>
Scene make_runway(std::string_view name, std::string_view description) {
  return {name, description, TexelFormat::kRgba8, false, paint_runway, project_runway<kView>};
}

}  // namespace

Scene runway_steep_scene() {
  return make_runway<kSteep>("runway_steep", "the runway from high above: footprints about twice as long as wide");
}

Scene runway_middle_scene() {
  return make_runway<kMiddle>("runway_middle",
                              "the runway at a middle pitch angle: about 5 times as long as wide in the distance");
}

Scene runway_scene() {
  return make_runway<kShallow>("runway", "a runway at a low pitch angle, two triangles interpolated with perspective");
}

Scene runway_low_scene() {
  return make_runway<kLow>("runway_low", "the runway at the lowest pitch angle: beyond 16 times as long as wide");
}

}  // namespace feline
