// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/scenes/scene.h"

namespace feline {

// A camera one unit above a plane, looking along it. Rays leave through a picture at distance 1
// that begins below the horizon, so that every one of them meets the plane.
struct GroundView {
  double top;       // slope below the horizon of the picture's upper edge, > 0
  double bottom;    // of its lower edge; bottom - top is the picture's height
  double width;     // of the picture; equal to its height for square pixels
  double cosine;    // of the angle by which the texture is turned, from a Pythagorean triple:
  double sine;      //   both rational, no libm
  double scale;     // texture repeats per unit
  double s_offset;  // texture coordinates below the camera
  double t_offset;
};

// Where the ray through (x, y) meets the plane. A pixel's footprint there is about 1 / slope times
// as long as it is wide: 18 at a slope of 0.055.
constexpr TexturePoint ground_point(const GroundView& view, const Dual& x, const Dual& y) {
  const Dual slope = view.top + (view.bottom - view.top) * y;
  const Dual ahead = 1.0 / slope;
  const Dual side = view.width * (x - 0.5) * ahead;
  return {view.s_offset + view.scale * (view.cosine * side + view.sine * ahead),
          view.t_offset + view.scale * (view.sine * side - view.cosine * ahead)};
}

}  // namespace feline
