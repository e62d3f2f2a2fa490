// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/vector.h"

namespace feline {
namespace {

// One swell of the sheet: phase = along_a * a + along_b * b + shift.
struct Swell {
  double height;
  double along_a;
  double along_b;
  double shift;
};

constexpr std::array<Swell, 3> kSwells = {{{0.034, 3.1, 1.1, 0.3}, {0.028, -1.2, 3.4, 0.1}, {0.012, 4.6, -4.1, 0.7}}};

// A mirror sheet around the plane z = 1, swollen. The ray through slopes (a, b) meets it where
// 1 / z = g(a, b): no search, and every pixel hits. As the surface is z g(x / z, y / z) = 1, its normal is
// (ga, gb, g - a ga - b gb), ga and gb being the derivatives of g.
Vector sheet_normal(const Dual& a, const Dual& b) {
  Dual g = 1.0;
  Dual slope_a = 0.0;
  Dual slope_b = 0.0;
  for (const Swell& swell : kSwells) {
    const Dual phase = swell.along_a * a + swell.along_b * b + swell.shift;
    const Dual slope = swell.height * wave_slope(phase);
    g = g + swell.height * wave(phase);
    slope_a = slope_a + swell.along_a * slope;
    slope_b = slope_b + swell.along_b * slope;
  }
  return normalize({slope_a, slope_b, g - a * slope_a - b * slope_b});
}

// The sphere map of OpenGL (specification 1.2, section 2.10.4), t downwards. Its z points to the camera.
// The map has no value where the reflection goes straight on (z = -1), which only a grazed surface does.
TexturePoint project_reflector(const Dual& x, const Dual& y) {
  constexpr double kPicture = 0.9;  // width and height, at distance 1
  const Dual a = kPicture * (x - 0.5);
  const Dual b = kPicture * (0.5 - y);
  const Vector mirrored = reflect(normalize({a, b, 1.0}), sheet_normal(a, b));
  const Dual toward = 1.0 - mirrored.z;
  const Dual m = 2.0 * sqrt(mirrored.x * mirrored.x + mirrored.y * mirrored.y + toward * toward);
  return {mirrored.x / m + 0.5, 0.5 - mirrored.y / m};
}

}  // namespace

Scene reflector_scene() {
  return {
      "reflector",         "a swollen mirror sheet, environment-mapped: a square under the sky in a sphere map; sRGB",
      TexelFormat::kRgba8, true,
      paint_environment,   project_reflector};
}

}  // namespace feline
