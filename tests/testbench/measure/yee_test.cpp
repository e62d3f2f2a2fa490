// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/yee.h"

#include <gtest/gtest.h>

#include "testbench/random.h"

namespace feline {
namespace {

constexpr int kSide = 48;
constexpr double kPerDegree = 10;

template <typename Value>
Displayed displayed(Value value) {
  Displayed picture{kSide, kSide, {}};
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) picture.pixels.push_back(value(column, row));
  }
  return picture;
}

Displayed grey(double value) {
  return displayed([=](int, int) { return std::array<double, 3>{value, value, value}; });
}

double part(const Displayed& a, const Displayed& b) {
  EXPECT_EQ(count_visible(a, b, kPerDegree), count_visible(b, a, kPerDegree));
  return static_cast<double>(count_visible(a, b, kPerDegree)) / (kSide * kSide);
}

// Even pictures have no contrast that would raise the threshold: it is Ward Larson's, worked out by hand in each of his
// cases, in cd/m^2 of 100.
TEST(measure_yee, the_threshold_of_even_pictures) {
  const auto seen = [](double luminance, double apart) {
    return part(grey((luminance - apart / 2) / 100), grey((luminance + apart / 2) / 100));
  };
  for (const auto& [luminance, least] :
       {std::pair(50.0, 3.0879), std::pair(0.5, 0.20136), std::pair(0.01, 0.0054723)}) {
    EXPECT_EQ(seen(luminance, 0.99 * least), 0) << luminance;
    EXPECT_EQ(seen(luminance, 1.01 * least), 1) << luminance;
  }
}

TEST(measure_yee, black_and_white) {
  EXPECT_EQ(part(grey(0), grey(1)), 1);
  EXPECT_EQ(part(grey(0), grey(0)), 0);
  EXPECT_EQ(part(grey(1), grey(1)), 0);
}

// As bright as each other by the weights 0.2126, 0.7152, 0.0722 of red, green and blue.
TEST(measure_yee, hues_are_seen_in_the_light) {
  const auto pair = [](double bright) {
    return part(displayed([=](int, int) {
                  return std::array<double, 3>{bright * 0.7152, 0, 0};
                }),
                displayed([=](int, int) {
                  return std::array<double, 3>{0, bright * 0.2126, 0};
                }));
  };
  EXPECT_EQ(pair(1), 1);
  EXPECT_EQ(pair(0.0001), 0);
}

TEST(measure_yee, only_where_they_differ) {
  const Displayed plain = grey(0.5);
  const Displayed spot = displayed([](int column, int row) {
    const double value = column >= 20 && column < 28 && row >= 8 && row < 16 ? 0.9 : 0.5;
    return std::array<double, 3>{value, value, value};
  });
  EXPECT_EQ(count_visible(plain, spot, kPerDegree), 64);
}

// The same difference between even pictures, and between noise that is as loud as it: noise hides it.
TEST(measure_yee, contrast_masks) {
  const auto noise = [](double more) {
    Random random(3);
    return displayed([&, more](int, int) {
      const double value = 0.3 + 0.4 * random.unit() + more;
      return std::array<double, 3>{value, value, value};
    });
  };
  EXPECT_EQ(part(grey(0.5), grey(0.56)), 1);
  EXPECT_LT(part(noise(0), noise(0.06)), 0.5);
  EXPECT_GT(part(noise(0), noise(0.5)), 0.9);
}

// Fine stripes raise their own threshold ten times, the most that there is.
TEST(measure_yee, masking_has_its_limit) {
  const auto stripes = [](double height) {
    return displayed([=](int column, int) {
      const double value = 0.5 + (column % 2 == 0 ? height : -height);
      return std::array<double, 3>{value, value, value};
    });
  };
  // The outermost columns have a neighbour less.
  EXPECT_LT(part(stripes(0.3), grey(0.5)), 0.1);
  EXPECT_GT(part(stripes(0.32), grey(0.5)), 0.9);
}

}  // namespace
}  // namespace feline
