// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace feline {
namespace {

FloatPicture filled(int width, int height, const std::array<float, 4>& pixel) {
  return {width, height, std::vector<std::array<float, 4>>(static_cast<std::size_t>(width * height), pixel)};
}

std::array<float, 4>& at(FloatPicture& picture, int column, int row) {
  return picture.pixels[static_cast<std::size_t>(row * picture.width + column)];
}

TEST(measure_errors, by_hand) {
  const FloatPicture truth = filled(4, 5, {0.5F, 0.5F, 0.5F, 1});
  FloatPicture picture = truth;
  at(picture, 1, 1)[0] = 0.75F;
  at(picture, 2, 3)[2] = 0;
  // Six pixels within the border, three channels each.
  const Errors errors = compare(picture, truth, 4);
  EXPECT_DOUBLE_EQ(errors.mean_square, (0.0625 + 0.25) / 18);
  EXPECT_DOUBLE_EQ(errors.rmse(), std::sqrt(0.3125 / 18));
  EXPECT_EQ(errors.worst, 0.5);
  EXPECT_EQ(errors.worst_column, 2);
  EXPECT_EQ(errors.worst_row, 3);
  EXPECT_EQ(compare(truth, picture, 4).mean_square, errors.mean_square);
}

TEST(measure_errors, borders_and_alpha_are_left_out) {
  const FloatPicture truth = filled(4, 3, {0, 0, 0, 1});
  FloatPicture picture = truth;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (row != 1 || column == 0 || column == 3) at(picture, column, row) = {1, 1, 1, 0};
    }
  }
  at(picture, 1, 1)[3] = 0;
  EXPECT_EQ(compare(picture, truth, 4).mean_square, 0);
  EXPECT_EQ(compare(picture, truth, 4).psnr(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(temporal_mean_square(truth, truth, picture, truth, 4), 0);
  // Unless nothing would be left.
  EXPECT_EQ(compare(filled(2, 9, {1, 0, 0, 1}), filled(2, 9, {0, 0, 0, 1}), 1).mean_square, 1);
}

TEST(measure_errors, of_the_textures_channels) {
  const FloatPicture truth = filled(3, 3, {0, 0, 0, 1});
  const FloatPicture picture = filled(3, 3, {0.25F, 0.5F, 1, 0});
  EXPECT_DOUBLE_EQ(compare(picture, truth, 1).mean_square, 0.0625);
  EXPECT_DOUBLE_EQ(compare(picture, truth, 2).mean_square, (0.0625 + 0.25) / 2);
  EXPECT_DOUBLE_EQ(compare(picture, truth, 4).mean_square, (0.0625 + 0.25 + 1) / 3);
  EXPECT_DOUBLE_EQ(temporal_mean_square(truth, truth, picture, truth, 1), 0.0625);
}

TEST(measure_errors, decibels) {
  EXPECT_NEAR(psnr_of(0.01), 20, 1e-12);
  EXPECT_NEAR(psnr_of(1), 0, 1e-12);
  EXPECT_NEAR((Errors{0.001, 0, 0, 0}.psnr()), 30, 1e-12);
}

TEST(measure_errors, shimmer_is_a_change_of_the_error) {
  const FloatPicture dark = filled(5, 5, {0.25F, 0.25F, 0.25F, 1});
  const FloatPicture bright = filled(5, 5, {0.5F, 0.5F, 0.5F, 1});
  const FloatPicture full = filled(5, 5, {0.75F, 0.75F, 0.75F, 1});
  // The scene changes and the error stays: 1/4 too bright before and after.
  EXPECT_EQ(temporal_mean_square(bright, dark, full, bright, 4), 0);
  // 1/4 too bright, then 1/4 too dark.
  EXPECT_DOUBLE_EQ(temporal_mean_square(full, bright, dark, bright, 4), 0.25);
  EXPECT_DOUBLE_EQ(temporal_mean_square(bright, bright, full, bright, 4), 0.0625);
}

TEST(measure_errors, as_json) {
  const Errors errors{0.25, 0.5, 3, 4};
  EXPECT_EQ(to_json(errors_from_json(to_json(errors))), to_json(errors));
  // Larger than the number that it would become.
  nlohmann::ordered_json other = to_json(errors);
  other["worst_row"] = 1e300;
  EXPECT_THROW(errors_from_json(other), std::exception);
}

}  // namespace
}  // namespace feline
