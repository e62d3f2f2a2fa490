// SPDX-License-Identifier: Apache-2.0
#include "tables/rounding.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/support/oracle.h"

namespace feline {
namespace {

// The table of the comment, in quarters.
TEST(rounding, truth_table) {
  constexpr std::array<std::int64_t, 8> kValue{-7, -6, -5, -4, 4, 5, 6, 7};
  constexpr std::array<std::int64_t, 8> kDown{-2, -2, -2, -1, 1, 1, 1, 1};
  constexpr std::array<std::int64_t, 8> kUpTies{-2, -1, -1, -1, 1, 1, 2, 2};
  constexpr std::array<std::int64_t, 8> kAwayTies{-2, -2, -1, -1, 1, 1, 2, 2};
  constexpr std::array<std::int64_t, 8> kOutward{-2, -2, -2, -1, 1, 2, 2, 2};
  for (std::size_t i = 0; i < kValue.size(); ++i) {
    EXPECT_EQ(round_down(kValue[i], 2), kDown[i]) << kValue[i];
    EXPECT_EQ(round_up_ties(kValue[i], 2), kUpTies[i]) << kValue[i];
    EXPECT_EQ(round_away_ties(kValue[i], 2), kAwayTies[i]) << kValue[i];
    EXPECT_EQ(round_outward(kValue[i], 2), kOutward[i]) << kValue[i];
  }
}

// All values of 12 bits and shifts of up to 13, and the same far from 0, against exact quotients.
TEST(rounding, equals_exact_arithmetic) {
  for (const std::int64_t offset : {std::int64_t{0}, std::int64_t{1} << 61, -(std::int64_t{1} << 61)}) {
    for (std::int64_t small = -2048; small <= 2048; ++small) {
      for (int bits = 0; bits <= 13; ++bits) {
        const std::int64_t value = offset + small;
        const oracle::Rational exact{value, oracle::Wide{1} << bits};
        const oracle::Wide outward = value < 0 ? oracle::floor_of(exact) : oracle::ceil_of(exact);
        ASSERT_EQ(round_down(value, bits), static_cast<std::int64_t>(oracle::floor_of(exact))) << value << " " << bits;
        ASSERT_EQ(round_up_ties(value, bits), static_cast<std::int64_t>(oracle::nearest_up(exact))) << value;
        ASSERT_EQ(round_away_ties(value, bits), static_cast<std::int64_t>(oracle::nearest_away(exact))) << value;
        ASSERT_EQ(round_outward(value, bits), static_cast<std::int64_t>(outward)) << value << " " << bits;
      }
    }
  }
}

// Shifts that leave one bit, or none, of the values with most bits, of either sign.
TEST(rounding, long_shifts) {
  for (const int most : {1, 41, 49, 61, 62}) {
    for (const std::int64_t magnitude : {std::int64_t{1} << (most - 1), (std::int64_t{1} << most) - 1}) {
      for (const std::int64_t value : {magnitude, -magnitude}) {
        for (int bits = 50; bits <= 64; ++bits) {
          const oracle::Rational exact{value, oracle::Wide{1} << bits};
          const oracle::Wide outward = value < 0 ? oracle::floor_of(exact) : oracle::ceil_of(exact);
          EXPECT_EQ(round_down(value, bits), static_cast<std::int64_t>(oracle::floor_of(exact)))
              << value << " " << bits;
          EXPECT_EQ(round_away_ties(value, bits), static_cast<std::int64_t>(oracle::nearest_away(exact)))
              << value << " " << bits;
          EXPECT_EQ(round_outward(value, bits), static_cast<std::int64_t>(outward)) << value << " " << bits;
        }
        for (int bits = 64; bits <= 300; ++bits) {
          EXPECT_EQ(round_outward(value, bits), value < 0 ? -1 : 1) << bits;
          EXPECT_EQ(round_away_ties(value, bits), 0) << bits;
          EXPECT_EQ(round_down(value, bits), value < 0 ? -1 : 0) << bits;
        }
      }
    }
  }
  EXPECT_EQ(round_down(std::int64_t{1} << 62, 62), 1);
  for (int bits = 50; bits <= 300; ++bits) {
    EXPECT_EQ(round_outward(0, bits), 0);
    EXPECT_EQ(round_away_ties(0, bits), 0);
    EXPECT_EQ(round_down(0, bits), 0);
  }
}

TEST(rounding, bit_length) {
  EXPECT_EQ(bit_length(0), 0);
  EXPECT_EQ(bit_length(1), 1);
  EXPECT_EQ(bit_length(7), 3);
  EXPECT_EQ(bit_length(8), 4);
  EXPECT_EQ(bit_length(INT64_MAX), 63);
}

}  // namespace
}  // namespace feline
