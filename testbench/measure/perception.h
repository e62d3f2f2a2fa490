// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/measure/float_picture.h"

namespace feline {

// How different two pictures of equal size look: libjxl's Butteraugli, its 3-norm over all pixels, on a display of
// 80 cd/m^2. 0 is equal; at about 1 a viewer begins to see a difference. One channel is shown as grey; `srgb`: the
// pictures are in linear light, otherwise their values are shown as sRGB codes. Values are clamped to 0 .. 1.
// Throws std::runtime_error when libjxl fails.
double perceptual_distance(const FloatPicture& picture, const FloatPicture& truth, bool srgb, int channels);

}  // namespace feline
