// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/errors.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace feline {
namespace {

// A border of one pixel, unless nothing would be left.
template <typename Visit>
void for_inner_pixels(const FloatPicture& picture, Visit visit) {
  const int border = std::min(picture.width, picture.height) > 2 ? 1 : 0;
  for (int row = border; row < picture.height - border; ++row) {
    for (int column = border; column < picture.width - border; ++column) {
      visit(column, row,
            static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(column));
    }
  }
}

int colours(int channels) { return std::min(channels, 3); }

// Display primaries in linear light, three channels; a single channel is grey.
std::vector<float> displayed(const FloatPicture& picture, bool srgb, int channels) {
  std::vector<float> values;
  values.reserve(3 * picture.pixels.size());
  for (const auto& pixel : picture.pixels) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = std::clamp(static_cast<double>(pixel[channels == 1 ? 0 : c]), 0.0, 1.0);
      const double linear = srgb ? value : value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
      values.push_back(static_cast<float>(linear));
    }
  }
  return values;
}

}  // namespace

double psnr_of(double mean_square) {
  return mean_square > 0 ? -10 * std::log10(mean_square) : std::numeric_limits<double>::infinity();
}

double Errors::rmse() const { return std::sqrt(mean_square); }
double Errors::psnr() const { return psnr_of(mean_square); }

Errors compare(const FloatPicture& picture, const FloatPicture& truth, int channels) {
  Errors errors;
  double values = 0;
  for_inner_pixels(picture, [&](int column, int row, std::size_t i) {
    for (int c = 0; c < colours(channels); ++c) {
      const auto channel = static_cast<std::size_t>(c);
      const double error = double{picture.pixels[i][channel]} - double{truth.pixels[i][channel]};
      errors.mean_square += error * error;
      values += 1;
      if (std::abs(error) <= errors.worst) continue;
      errors.worst = std::abs(error);
      errors.worst_column = column;
      errors.worst_row = row;
    }
  });
  errors.mean_square /= values;
  return errors;
}

double temporal_mean_square(const FloatPicture& before, const FloatPicture& truth_before, const FloatPicture& after,
                            const FloatPicture& truth_after, int channels) {
  double sum = 0;
  double values = 0;
  for_inner_pixels(before, [&](int, int, std::size_t i) {
    for (int c = 0; c < colours(channels); ++c) {
      const auto channel = static_cast<std::size_t>(c);
      const double change = (double{after.pixels[i][channel]} - double{truth_after.pixels[i][channel]}) -
                            (double{before.pixels[i][channel]} - double{truth_before.pixels[i][channel]});
      sum += change * change;
      values += 1;
    }
  });
  return sum / values;
}

double visible_difference(const FloatPicture& picture, const FloatPicture& truth, int whole_width, bool srgb,
                          int channels) {
  std::vector<float> a = displayed(picture, srgb, channels);
  std::vector<float> b = displayed(truth, srgb, channels);
  const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::FLOAT);
  const OIIO::ImageBuf a_image(spec, a.data());
  const OIIO::ImageBuf b_image(spec, b.data());
  OIIO::ImageBufAlgo::CompareResults results;
  const int failing = OIIO::ImageBufAlgo::compare_Yee(
      a_image, b_image, results, 100, 45 * static_cast<float>(picture.width) / static_cast<float>(whole_width));
  return static_cast<double>(failing) / (static_cast<double>(picture.width) * picture.height);
}

}  // namespace feline
