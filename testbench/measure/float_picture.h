// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "testbench/atomic_file.h"

namespace feline {

// A picture in linear light before it is stored; red, green, blue, alpha, 1 is full.
struct FloatPicture {
  int width = 0;
  int height = 0;
  std::vector<std::array<float, 4>> pixels;  // row-major

  const std::array<float, 4>& at(int column, int row) const {
    return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
};

// A square of a picture that is looked at closely.
struct Detail {
  int left = 0;
  int top = 0;
  int size = 0;
};

// The part of the picture that lies within it.
FloatPicture crop(const FloatPicture& picture, const Detail& detail);

// Nearest 8 bit codes; with `srgb` encoded (IEC 61966-2-1), alpha not. Three channels, or four.
std::vector<std::uint8_t> to_bytes(const FloatPicture& picture, bool srgb, int channels);

// As PNG, RGBA, whole or not at all.
void write_picture(OutputFiles& outputs, const std::filesystem::path& path, const FloatPicture& picture, bool srgb);

// Half grey where equal; `gain` times the difference a - b around it.
FloatPicture difference(const FloatPicture& a, const FloatPicture& b, float gain);

}  // namespace feline
