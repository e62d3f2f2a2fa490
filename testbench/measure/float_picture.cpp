// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/float_picture.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "testbench/image.h"
#include "testbench/srgb.h"

namespace feline {
namespace {

std::uint8_t to_code(float value, bool srgb) {
  const double clamped = std::clamp(static_cast<double>(value), 0.0, 1.0);
  return static_cast<std::uint8_t>(std::floor(255 * (srgb ? linear_to_srgb(clamped) : clamped) + 0.5));
}

}  // namespace

FloatPicture crop(const FloatPicture& picture, const Detail& detail) {
  const auto& [left, top, size] = detail;
  FloatPicture part{std::min(size, picture.width - left), std::min(size, picture.height - top), {}};
  for (int row = 0; row < part.height; ++row) {
    for (int column = 0; column < part.width; ++column) part.pixels.push_back(picture.at(left + column, top + row));
  }
  return part;
}

std::vector<std::uint8_t> to_bytes(const FloatPicture& picture, bool srgb, int channels) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.pixels.size() * static_cast<std::size_t>(channels));
  for (const auto& pixel : picture.pixels) {
    for (int c = 0; c < channels; ++c) bytes.push_back(to_code(pixel[static_cast<std::size_t>(c)], srgb && c < 3));
  }
  return bytes;
}

void write_picture(OutputFiles& outputs, const std::filesystem::path& path, const FloatPicture& picture, bool srgb) {
  const std::vector<std::uint8_t> bytes = to_bytes(picture, srgb, 4);
  write_png(outputs, path, picture.width, picture.height, 4, std::span<const std::uint8_t>(bytes));
}

FloatPicture difference(const FloatPicture& a, const FloatPicture& b, float gain) {
  FloatPicture result{a.width, a.height, {}};
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    std::array<float, 4> pixel{0, 0, 0, 1};
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = 0.5f + gain * (a.pixels[i][c] - b.pixels[i][c]);
    result.pixels.push_back(pixel);
  }
  return result;
}

}  // namespace feline
