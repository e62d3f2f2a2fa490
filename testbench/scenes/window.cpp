// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/paint.h"
#include "testbench/scenes/vector.h"

namespace feline {
namespace {

constexpr int kWidth = 600;  // neither side is a power of two
constexpr int kHeight = 840;

constexpr std::array<Colour, 7> kGlass = {{{0.09, 0.22, 0.66},
                                           {0.83, 0.13, 0.13},
                                           {0.98, 0.76, 0.16},
                                           {0.10, 0.50, 0.28},
                                           {0.52, 0.16, 0.56},
                                           {0.14, 0.55, 0.80},
                                           {0.96, 0.50, 0.10}}};
constexpr Colour kShadow = {0.13, 0.11, 0.12};  // stone and lead: no light

constexpr double kRoseX = 300.0;
constexpr double kRoseY = 300.0;
constexpr double kRoseRadius = 150.0;

double length(double x, double y) { return std::sqrt(x * x + y * y); }

// The piece of glass at a point: how far the lead is, in texels, and its colour.
struct Pane {
  double to_lead;
  Colour colour;
};

// The nearest of the sites decides the piece; lead runs where two are equally near.
class PaneFinder {
 public:
  PaneFinder(double x, double y) : x_(x), y_(y) {}
  void site(double x, double y, double hue) {
    const double distance = length(x_ - x, y_ - y);
    if (distance < nearest_) {
      second_ = nearest_;
      nearest_ = distance;
      hue_ = hue;
    } else if (distance < second_) {
      second_ = distance;
    }
  }
  Pane pane() const { return {(second_ - nearest_) / 2.0, kGlass[static_cast<std::size_t>(hue_ * kGlass.size())]}; }

 private:
  double x_;
  double y_;
  double nearest_ = 1e9;
  double second_ = 1e9;
  double hue_ = 0.0;
};

// Sixteen petals around a gold eye.
Pane rose(double x, double y) {
  constexpr double kDiagonal = 0.70710678118654752;
  constexpr std::array<std::array<double, 2>, 8> kDirections = {{{1, 0},
                                                                 {kDiagonal, kDiagonal},
                                                                 {0, 1},
                                                                 {-kDiagonal, kDiagonal},
                                                                 {-1, 0},
                                                                 {-kDiagonal, -kDiagonal},
                                                                 {0, -1},
                                                                 {kDiagonal, -kDiagonal}}};
  PaneFinder finder(x, y);
  finder.site(0, 0, 0.3);
  for (std::size_t i = 0; i < kDirections.size(); ++i) {
    const double hue = i % 2 == 0 ? 0.15 : 0.05;
    finder.site(65 * kDirections[i][0], 65 * kDirections[i][1], hue);
    finder.site(135 * kDirections[i][0], 135 * kDirections[i][1], i % 2 == 0 ? 0.75 : 0.6);
  }
  return finder.pane();
}

// Irregular pieces, one a cell of a jittered grid, the right half mirroring the left.
Pane mosaic(double x, double y) {
  constexpr double kCell = 58.0;
  const double mirrored = std::abs(x - kWidth / 2.0);
  const int column = static_cast<int>(mirrored / kCell);
  const int row = static_cast<int>(y / kCell);
  PaneFinder finder(mirrored, y);
  for (int j = row - 2; j <= row + 2; ++j) {
    for (int i = column - 2; i <= column + 2; ++i) {
      finder.site((i + 0.15 + 0.7 * hash01(i, j, 61)) * kCell, (j + 0.15 + 0.7 * hash01(i, j, 62)) * kCell,
                  hash01(i, j, 63));
    }
  }
  return finder.pane();
}

// Texels to the outline of the opening, positive inside: a pointed arch of two circles on a
// rectangle.
double inside_opening(double x, double y) {
  constexpr double kFrame = 36.0;
  constexpr double kSpring = 500.0;  // the row where the arch begins
  constexpr double kRadius = 528.0;  // as wide as the opening: an equilateral arch
  const double side = std::abs(x - kWidth / 2.0);
  const double bottom = kHeight - kFrame - y;
  const double wall = y > kSpring ? kWidth / 2.0 - kFrame - side : kRadius - length(side + kRadius / 2.0, y - kSpring);
  return wall < bottom ? wall : bottom;
}

Colour window_at(double u, double v) {
  const double from_rose = length(u - kRoseX, v - kRoseY);
  const bool in_rose = from_rose < kRoseRadius;
  Pane pane = in_rose ? rose(u - kRoseX, v - kRoseY) : mosaic(u, v);
  const double ring = std::abs(from_rose - kRoseRadius) - 3.0;
  const double mullion = in_rose ? 1e9 : std::abs(std::abs(u - kWidth / 2.0) - 88.0) - 4.0;
  const double saddle = in_rose ? 1e9 : std::abs(std::fmod(v, 168.0) - 84.0) - 2.0;
  for (const double lead : {ring, mullion, saddle, inside_opening(u, v) - 3.0}) {
    if (lead < pane.to_lead) pane.to_lead = lead;
  }
  // Old glass: thick and thin, and brighter away from the lead.
  const double thickness = 0.8 + 0.4 * fractal_noise(u / 20, v / 20, 30 * 42, 64);
  const double glow = 0.75 + 0.35 * clamp01(pane.to_lead / 20.0);
  return mix(kShadow, (thickness * glow) * pane.colour, smooth_step(2.6, 0.8, pane.to_lead));
}

MipLevel paint_window() { return paint_rgba(kWidth, kHeight, window_at); }

// A camera looks at a hollow wall, a cylinder about a vertical axis. The sun stands to the left,
// almost along the wall, and shines through windows in the plane x = kWindow.
TexturePoint project_window(const Dual& x, const Dual& y) {
  constexpr double kWindow = -3.0;
  constexpr double kRadius = 5.0;
  const Vector sun = {1.0, -1.4, 0.285};
  const Vector ray = {1.3 * (x - 0.5), 1.3 * (0.5 - y), 1.0};
  // The wall: x^2 + (z + 3)^2 = kRadius^2, seen from the origin, which is inside.
  const Dual a = ray.x * ray.x + ray.z * ray.z;
  const Dual b = 3.0 * ray.z;
  const Dual c = 9.0 - kRadius * kRadius;
  const Vector wall = ((sqrt(b * b - a * c) - b) / a) * ray;
  const Vector lit = wall - (wall.x - kWindow) / sun.x * sun;
  return {lit.z / 0.8 - 0.75, 1.3 - lit.y / 2.2};
}

}  // namespace

Scene window_scene() {
  return {"window",
          "light of a stained-glass window grazing a hollow wall; 600 x 840, sRGB",
          TexelFormat::kRgba8,
          true,
          paint_window,
          project_window};
}

}  // namespace feline
