// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/detail.h"

#include <algorithm>

#include "testbench/image.h"
#include "testbench/picture.h"

namespace feline {
namespace {

double distance(const FloatPicture& a, const FloatPicture& b, const Detail& detail) {
  double sum = 0;
  for (int row = detail.top; row < std::min(detail.top + detail.size, a.height); ++row) {
    for (int column = detail.left; column < std::min(detail.left + detail.size, a.width); ++column) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double apart = double{a.at(column, row)[c]} - double{b.at(column, row)[c]};
        sum += apart * apart;
      }
    }
  }
  return sum;
}

}  // namespace

Detail find_detail(const FloatPicture& a, const FloatPicture& b, int size) {
  Detail best{0, 0, size};
  double most = -1;
  const int step = std::max(size / 2, 1);
  for (int top = 0; top == 0 || top + size <= a.height; top += step) {
    for (int left = 0; left == 0 || left + size <= a.width; left += step) {
      const Detail here{left, top, size};
      const double sum = distance(a, b, here);
      if (sum <= most) continue;
      most = sum;
      best = here;
    }
  }
  return best;
}

std::vector<std::byte> picture_png(const FloatPicture& picture, bool srgb, int channels) {
  const int stored = channels == 1 ? 1 : 3;
  const std::vector<std::uint8_t> bytes = to_bytes(picture, srgb, stored);
  return encode_png("memory", picture.width, picture.height, stored, std::span<const std::uint8_t>(bytes));
}

std::vector<std::byte> detail_png(const FloatPicture& picture, const Detail& detail, bool srgb, int channels) {
  return picture_png(crop(picture, detail), srgb, channels);
}

std::vector<std::byte> probes_png(std::span<const float> probes, int width, const Detail& detail) {
  const int height = static_cast<int>(probes.size()) / width;
  const int columns = std::min(detail.size, width - detail.left);
  const int rows = std::min(detail.size, height - detail.top);
  std::vector<std::uint8_t> bytes;
  for (int row = detail.top; row < detail.top + rows; ++row) {
    for (int column = detail.left; column < detail.left + columns; ++column) {
      const auto pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
      for (const int channel : probe_colour(static_cast<int>(probes[pixel]))) {
        bytes.push_back(static_cast<std::uint8_t>(channel));
      }
    }
  }
  return encode_png("memory", columns, rows, 3, std::span<const std::uint8_t>(bytes));
}

}  // namespace feline
