// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "testbench/scenes/builtin.h"
#include "testbench/scenes/ground.h"

namespace feline {
namespace {

// Seen from far off through a long lens, so that the footprint is everywhere about 8 times as long as
// wide. The plane turns about the point in the middle of the picture, 0.105 degrees a frame: at
// 512 x 512 the upper and lower edges move by 3.6 pixels a frame, the middle stands still.
template <int kFrame>
TexturePoint project_spin(const Dual& x, const Dual& y) {
  constexpr double kTangent = (256.0 + kFrame) / 1024.0;  // of half of the angle
  constexpr double kSquare = kTangent * kTangent;
  constexpr double kCosine = (1.0 - kSquare) / (1.0 + kSquare);
  constexpr double kSine = 2.0 * kTangent / (1.0 + kSquare);
  constexpr double kTop = 0.095;
  constexpr double kBottom = 0.165;
  constexpr double kScale = 2.0;
  constexpr double kMiddle = 2.0 / (kTop + kBottom);  // how far ahead the middle of the picture is
  constexpr GroundView kView = {.top = kTop,
                                .bottom = kBottom,
                                .width = kBottom - kTop,
                                .cosine = kCosine,
                                .sine = kSine,
                                .scale = kScale,
                                .s_offset = 0.5 - kScale * kSine * kMiddle,
                                .t_offset = 0.5 + kScale * kCosine * kMiddle};
  return ground_point(kView, x, y);
}

constexpr std::array<Projection*, 7> kLaterFrames = {project_spin<1>, project_spin<2>, project_spin<3>, project_spin<4>,
                                                     project_spin<5>, project_spin<6>, project_spin<7>};

}  // namespace

Scene spin_scene() {
  return {"spin",
          "a sequence of 8 frames: a marble checkerboard, 8 times foreshortened, that turns slowly",
          TexelFormat::kRgba8,
          false,
          paint_checkerboard,
          project_spin<0>,
          kLaterFrames};
}

}  // namespace feline
