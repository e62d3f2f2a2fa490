// SPDX-License-Identifier: Apache-2.0
#include "model/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/describe.h"
#include "tests/support/footprints.h"
#include "tests/support/oracle.h"
#include "tests/support/random_beat.h"

namespace feline {
namespace {

constexpr std::array kModes{Mode::kNearest, Mode::kBilinear, Mode::kTrilinear, Mode::kExt, Mode::kSimple, Mode::kTable};

void expect_as_oracle(const GroupBeat<kDefaultConfig>& grouped, Mode mode) {
  const State state = state_of(mode);
  const auto got = footprint<kDefaultConfig>(grouped, state);
  const auto want = oracle::footprint(grouped, state);
  ASSERT_TRUE(same(got, want)) << mode_name(mode) << " " << mismatch(got, want, grouped);
}

// 1,000,000 quadruples; a quarter uniform, a quarter small, a quarter nearly parallel, a quarter nearly circles.
TEST(footprint, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_footprint.equals_exact_arithmetic");
  for (int i = 0; i < 1000000 && !HasFatalFailure(); ++i) {
    auto grouped = group_beat(random_quad(random), 0);
    draw(random, grouped.exponent);
    draw(random, grouped.s);
    draw(random, grouped.t);
    draw_what_is_handed_on(random, grouped);
    expect_as_oracle(grouped, random.pick(kModes));
  }
}

// Every quadruple of edge mantissas in the three modes that look at both vectors: 3 * 21^4 = 583,443.
TEST(footprint, lattice_of_edge_mantissas) {
  constexpr std::array<int, 21> kEdges{-127, -126, -85, -64, -63, -45, -32, -7, -2,  -1, 0,
                                       1,    2,    7,   32,  44,  45,  63,  64, 120, 127};
  for (const int a : kEdges) {
    for (const int b : kEdges) {
      for (const int c : kEdges) {
        for (const int d : kEdges) {
          for (const Mode mode : {Mode::kExt, Mode::kSimple, Mode::kTable})
            expect_as_oracle(group_beat({a, b, c, d}, 0), mode);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

// Erratum 10. Over all vectors of 8-bit mantissas the larger of the two parts is within the extremes of the continuous
// function: at b = 5a/32 the first part is sqrt(1 + 25/1024) of the length, at the second's own direction
// (109/128, 35/64) it is |(109, 70)|/128, and where they cross, b = 19a/50, it is least.
TEST(footprint, length_error_extremes) {
  double most = 0;
  double least = 0;
  for (int a = 0; a <= 127; ++a) {
    for (int b = 0; b <= 127; ++b) {
      if (a == 0 && b == 0) continue;
      const double error = static_cast<double>(vector_length(a, b)) / 128 / std::hypot(a, b) - 1;
      most = std::max(most, error);
      least = std::min(least, error);
      EXPECT_EQ(vector_length(a, b), vector_length(b, -a));
      EXPECT_EQ(vector_length(a, b), vector_length(-a, -b));
    }
  }
  const double first_part = std::sqrt(1 + 25.0 / 1024) - 1;
  const double second_part = std::hypot(109.0, 70.0) / 128 - 1;
  const double crossing = (1 + 5.0 / 32 * 0.38) / std::hypot(1, 0.38) - 1;
  const double diagonal = 179.0 / 128 / std::sqrt(2.0) - 1;
  EXPECT_NEAR(first_part, 0.01213, 5e-6);
  EXPECT_NEAR(diagonal, -0.01116, 5e-6);
  EXPECT_LE(most, std::max(first_part, second_part) + 1e-12);
  EXPECT_GE(least, std::min(crossing, diagonal) - 1e-12);
  EXPECT_NEAR(most, 0.01213, 5e-6);
  EXPECT_NEAR(least, -0.01116, 5e-6);
}

std::int64_t printed_length(std::int64_t a, std::int64_t b) {
  return 8 * b < 3 * a ? 128 * a + 20 * b : 109 * a + 70 * b;
}

// Why the larger part is taken: the printed choice falls where b reaches 3a/8; ours never does, over all 2^14 pairs.
TEST(footprint, length_is_monotonic_and_the_printed_one_is_not) {
  EXPECT_GT(printed_length(120, 44), printed_length(120, 45));
  int falls = 0;
  for (int a = 0; a <= 127; ++a) {
    for (int b = 0; b <= 127; ++b) {
      ASSERT_LT(vector_length(a, b), vector_length(a + 1, b)) << a << " " << b;
      ASSERT_LT(vector_length(a, b), vector_length(a, b + 1)) << a << " " << b;
      if (b < a && printed_length(a, b + 1) < printed_length(a, b)) ++falls;
      ASSERT_GE(vector_length(a, b), b <= a ? printed_length(a, b) : printed_length(b, a));
    }
  }
  EXPECT_GT(falls, 0);
}

// In every cell of the table: with m the longer mantissa, each part of the vector is at most m (2 uvScale + uvScale90)
// in units of 1/256, and the radius at least m majorRadius - 1/2 in units of 1/128. Elsewhere it is m against m.
TEST(footprint, no_vector_is_longer_than_twice_its_radius) {
  for (const std::uint64_t word : roms<kDefaultConfig>().ellipse.words) {
    const EllipseEntry entry = ellipse_entry(kDefaultConfig, word);
    EXPECT_LE(2 * entry.uv_scale + entry.uv_scale_90 + 2, 4 * entry.major_radius) << word;
  }
}

// (13, 0) and (12, 5) texels a pixel.
TEST(footprint, the_papers_example) {
  const Quad quad{104, 0, 96, 40};  // times 2^-3
  const auto exact = oracle::ellipse(12.0 / 13 * std::hypot(1, 5.0 / 12), std::atan2(5.0, 12.0));
  EXPECT_NEAR(13 * exact[3], 18.028, 5e-4);
  EXPECT_NEAR(13 * exact[2], 3.606, 5e-4);
  EXPECT_NEAR(2 * exact[3] / exact[2] - 1, 9, 1e-9);
  const auto simple = footprint<kDefaultConfig>(group_beat(quad, -3), state_of(Mode::kSimple));
  EXPECT_NEAR(simple.major_radius.value() / 8, 13, 0.012 * 13);
  EXPECT_NEAR(simple.minor_radius.value() / 8, std::hypot(1, 5), 0.012 * 5.1);
  const auto table = footprint<kDefaultConfig>(group_beat(quad, -3), state_of(Mode::kTable));
  // Within the table's stated error, 0.461 of the longer vector, and much nearer: what this cell gives.
  EXPECT_NEAR(table.major_radius.value() / 8, 18.028, 0.02 * 18);
  EXPECT_NEAR(table.minor_radius.value() / 8, 3.606, 0.08 * 3.606);
}

// Erratum 3. Equal lengths: y is the long vector. Zero vectors have an ellipse.
TEST(footprint, ties_and_zeros) {
  for (const Mode mode : {Mode::kExt, Mode::kSimple, Mode::kTable}) {
    const auto tie = footprint<kDefaultConfig>(group_beat({100, 0, 0, 100}, 0), state_of(mode));
    EXPECT_EQ(tie.major_u.raw(), 0) << mode_name(mode);
    EXPECT_GT(tie.major_v.raw(), 0) << mode_name(mode);
    for (const Quad& quad : {Quad{100, 20, 0, 0}, Quad{0, 0, 100, 20}}) {
      const auto line = footprint<kDefaultConfig>(group_beat(quad, 0), state_of(mode));
      EXPECT_EQ(line.major_radius.raw(), vector_length(100, 20)) << mode_name(mode);
      // The table's first cell stands for ratios up to 1/16, so its minor radius is not 0.
      const auto& entry = oracle::tables().ellipse[0][8];
      const auto least = mode == Mode::kTable ? (vector_length(100, 20) * entry[2] + 128) / 256 : 0;
      EXPECT_EQ(line.minor_radius.raw(), least) << mode_name(mode);
      EXPECT_EQ(line.major_u.raw(), 100 * 256) << mode_name(mode);
      EXPECT_EQ(line.major_v.raw(), 20 * 256) << mode_name(mode);
    }
    const auto none = footprint<kDefaultConfig>(group_beat({0, 0, 0, 0}, 0), state_of(mode));
    EXPECT_EQ(none.major_radius.raw(), 0) << mode_name(mode);
    EXPECT_EQ(none.minor_radius.raw(), 0) << mode_name(mode);
    EXPECT_EQ(none.major_u.raw(), 0) << mode_name(mode);
  }
  // Right angles and parallels turn nothing.
  for (const Quad& quad : {Quad{100, 20, -10, 50}, Quad{100, 20, 50, 10}}) {
    const auto beat = footprint<kDefaultConfig>(group_beat(quad, 0), state_of(Mode::kTable));
    EXPECT_EQ(beat.major_u.raw() * 20, beat.major_v.raw() * 100);
  }
}

}  // namespace
}  // namespace feline
