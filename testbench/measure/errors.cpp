// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "testbench/json_input.h"

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

}  // namespace

double psnr_of(double mean_square) {
  return mean_square > 0 ? -10 * std::log10(mean_square) : std::numeric_limits<double>::infinity();
}

double Errors::rmse() const { return std::sqrt(mean_square); }
double Errors::psnr() const { return psnr_of(mean_square); }

nlohmann::ordered_json to_json(const Errors& errors) {
  return {{"mean_square", errors.mean_square},
          {"worst", errors.worst},
          {"worst_column", errors.worst_column},
          {"worst_row", errors.worst_row}};
}

Errors errors_from_json(const nlohmann::ordered_json& json) {
  return {json.at("mean_square"), json.at("worst"), whole_from_json<int>(json.at("worst_column")),
          whole_from_json<int>(json.at("worst_row"))};
}

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

}  // namespace feline
