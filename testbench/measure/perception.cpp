// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/perception.h"

#include <jxl/butteraugli.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "testbench/srgb.h"

namespace feline {
namespace {

constexpr int kLeastSide = 8;  // libjxl finds smaller pictures equal
constexpr float kNorm = 3;
constexpr float kFull = 80;  // cd/m^2 of an sRGB display's white

struct Deleter {
  void operator()(JxlButteraugliApi* api) const { JxlButteraugliApiDestroy(api); }
  void operator()(JxlButteraugliResult* result) const { JxlButteraugliResultDestroy(result); }
};

// What is on the display, as libjxl takes it: sRGB codes, 1 is full. The edges of a small picture go on.
std::vector<float> displayed(const FloatPicture& picture, bool srgb, int channels) {
  const int width = std::max(picture.width, kLeastSide);
  const int height = std::max(picture.height, kLeastSide);
  std::vector<float> values;
  values.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto& pixel = picture.at(std::min(column, picture.width - 1), std::min(row, picture.height - 1));
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = std::clamp(static_cast<double>(pixel[channels == 1 ? 0 : c]), 0.0, 1.0);
        values.push_back(static_cast<float>(srgb ? linear_to_srgb(value) : value));
      }
    }
  }
  return values;
}

}  // namespace

double perceptual_distance(const FloatPicture& picture, const FloatPicture& truth, bool srgb, int channels) {
  const std::vector<float> seen = displayed(picture, srgb, channels);
  const std::vector<float> meant = displayed(truth, srgb, channels);
  const std::unique_ptr<JxlButteraugliApi, Deleter> api(JxlButteraugliApiCreate(nullptr));
  if (!api) throw std::runtime_error("libjxl: no Butteraugli");
  JxlButteraugliApiSetIntensityTarget(api.get(), kFull);
  constexpr JxlPixelFormat kFormat{3, JXL_TYPE_FLOAT, JXL_NATIVE_ENDIAN, 0};
  const std::unique_ptr<JxlButteraugliResult, Deleter> result(
      JxlButteraugliCompute(api.get(), static_cast<std::uint32_t>(std::max(picture.width, kLeastSide)),
                            static_cast<std::uint32_t>(std::max(picture.height, kLeastSide)), &kFormat, meant.data(),
                            meant.size() * sizeof(float), &kFormat, seen.data(), seen.size() * sizeof(float)));
  if (!result) throw std::runtime_error("libjxl: Butteraugli failed");
  return double{JxlButteraugliResultGetDistance(result.get(), kNorm)};
}

}  // namespace feline
