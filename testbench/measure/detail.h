// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "testbench/measure/float_picture.h"

namespace feline {

// How much differences are amplified for the eye.
inline constexpr float kDifferenceGain = 4;

// The square, on a grid of half its size, in which two pictures differ most.
Detail find_detail(const FloatPicture& a, const FloatPicture& b, int size);

// PNG files. One channel is shown as grey.
std::vector<std::byte> picture_png(const FloatPicture& picture, bool srgb, int channels);
std::vector<std::byte> detail_png(const FloatPicture& picture, const Detail& detail, bool srgb, int channels);
// Probes a pixel in the colours of Feline's figures 33 and 34.
std::vector<std::byte> probes_png(std::span<const float> probes, int width, const Detail& detail);

}  // namespace feline
