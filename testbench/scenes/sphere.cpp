// SPDX-License-Identifier: Apache-2.0
#include "testbench/scenes/builtin.h"
#include "testbench/scenes/vector.h"

namespace feline {
namespace {

// A mirror sphere at (0, 0, 3) of radius 1 with ripples fills the picture and shows the plane
// behind the camera. Ripples bend the normals only, as a bump map does: each axis by a wave along
// the other, which shears the reflection, and steeply enough to fold it.
Vector ripple(const Vector& p) {
  constexpr double kHeight = 0.073;
  constexpr double kFrequency = 6.0;
  const Dual bend_x = wave(kFrequency * (p.y + 0.3 * p.x));
  const Dual bend_y = wave(kFrequency * (p.x - 0.25 * p.y) + 0.4);
  return normalize(p + kHeight * Vector{bend_x, bend_y, 0.0});
}

TexturePoint project_sphere(const Dual& x, const Dual& y) {
  constexpr double kHalfPicture = 0.175;  // at distance 1: small enough that every ray comes back
  constexpr double kPlane = -1.5;         // z of the plane
  const Vector centre = {0.0, 0.0, 3.0};
  const Vector ray = normalize({kHalfPicture * (2.0 * x - 1.0), kHalfPicture * (1.0 - 2.0 * y), 1.0});
  const Dual middle = dot(ray, centre);
  const Dual distance = middle - sqrt(middle * middle - dot(centre, centre) + 1.0);
  const Vector hit = distance * ray;
  const Vector mirrored = reflect(ray, ripple(hit - centre));
  const Dual reach = (kPlane - hit.z) / mirrored.z;
  const Vector seen = hit + reach * mirrored;
  return {0.5 + 0.25 * seen.x, 0.5 - 0.25 * seen.y};
}

}  // namespace

Scene sphere_scene() {
  return {"sphere",
          "a rippled mirror sphere that reflects a marble checkerboard",
          TexelFormat::kRgba8,
          false,
          paint_checkerboard,
          project_sphere};
}

}  // namespace feline
