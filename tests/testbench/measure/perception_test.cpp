// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/perception.h"

#include <gtest/gtest.h>

#include <cmath>

namespace feline {
namespace {

constexpr int kPerceptionSide = 64;

template <typename ValueOf>
FloatPicture picture_of(int width, int height, ValueOf value_of) {
  FloatPicture picture{width, height, {}};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto value = static_cast<float>(value_of(column, row));
      picture.pixels.push_back({value, value, value, 1});
    }
  }
  return picture;
}

FloatPicture grey(double value, int width = kPerceptionSide, int height = kPerceptionSide) {
  return picture_of(width, height, [=](int, int) { return value; });
}

double codes(const FloatPicture& a, const FloatPicture& b) { return perceptual_distance(a, b, false, 3); }

TEST(measure_perception, equal_pictures) {
  EXPECT_EQ(codes(grey(0.5), grey(0.5)), 0);
  EXPECT_EQ(perceptual_distance(grey(0.5), grey(0.5), true, 4), 0);
}

// One sRGB code of 255 is at the limit of what is seen, more in the dark; ten are far beyond.
TEST(measure_perception, codes_of_grey) {
  const double step = 1.0 / 255;
  EXPECT_GT(codes(grey(0.5), grey(0.5 + step)), 0.5);
  EXPECT_LT(codes(grey(0.5), grey(0.5 + step)), 2);
  EXPECT_LT(codes(grey(0.9), grey(0.9 + step)), 1);
  EXPECT_GT(codes(grey(0.05), grey(0.05 + step)), 2);
  EXPECT_GT(codes(grey(0.5), grey(0.5 + 10 * step)), 5);
  EXPECT_GT(codes(grey(0), grey(1)), 50);
}

// Linear light is encoded: 0.2140 is the light of code 0.5, as IEC 61966-2-1 has it.
TEST(measure_perception, light_is_encoded) {
  const double light = std::pow((0.5 + 0.055) / 1.055, 2.4);
  EXPECT_NEAR(perceptual_distance(grey(light), grey(0), true, 3), codes(grey(0.5), grey(0)), 1e-3);
  EXPECT_GT(std::abs(codes(grey(light), grey(0)) - codes(grey(0.5), grey(0))), 1);
}

TEST(measure_perception, beyond_the_display) {
  EXPECT_EQ(codes(grey(1.5), grey(1)), 0);
  EXPECT_EQ(codes(grey(-0.5), grey(0)), 0);
}

// A single channel is grey, and alpha is not seen.
TEST(measure_perception, channels) {
  FloatPicture red = grey(0.5);
  for (auto& pixel : red.pixels) pixel = {0.5F, 0, 1, 1};
  EXPECT_EQ(perceptual_distance(red, grey(0.5), false, 1), 0);
  EXPECT_GT(perceptual_distance(red, grey(0.5), false, 3), 1);
  FloatPicture clear = grey(0.5);
  for (auto& pixel : clear.pixels) pixel[3] = 0;
  EXPECT_EQ(perceptual_distance(clear, grey(0.5), false, 4), 0);
}

// What the mean square cannot tell: a pattern hides the same error in a busy picture, and not on an even one.
TEST(measure_perception, patterns_hide_errors) {
  const auto noise = [](int column, int row) {
    return std::fmod(0.618034 * (37 * column + 91 * row) + 0.31 * column * row, 1);
  };
  const auto ripple = [](int column, int row) { return (column + row) % 2 == 0 ? 0.02 : -0.02; };
  const auto busy = [&](int column, int row) { return 0.3 + 0.4 * noise(column, row); };
  const double on_even = codes(
      picture_of(kPerceptionSide, kPerceptionSide, [&](int column, int row) { return 0.5 + ripple(column, row); }),
      grey(0.5));
  const double on_busy = codes(picture_of(kPerceptionSide, kPerceptionSide,
                                          [&](int column, int row) { return busy(column, row) + ripple(column, row); }),
                               picture_of(kPerceptionSide, kPerceptionSide, busy));
  EXPECT_LT(on_busy, on_even);
}

TEST(measure_perception, small_pictures) {
  for (const int side : {1, 2, 7}) {
    EXPECT_EQ(codes(grey(0.5, side, 1), grey(0.5, side, 1)), 0) << side;
    EXPECT_GT(codes(grey(0.5, side, 1), grey(0.6, side, 1)), 1) << side;
    EXPECT_GT(codes(grey(0.5, 1, side), grey(0.6, 1, side)), 1) << side;
  }
  EXPECT_GT(codes(grey(0.5, 300, 3), grey(0.6, 300, 3)), 1);
}

}  // namespace
}  // namespace feline
