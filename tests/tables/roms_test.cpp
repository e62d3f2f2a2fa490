// SPDX-License-Identifier: Apache-2.0
// Every word of every ROM against MPFR at 200 bits, and every stated error against one computed here.
#include "tables/roms.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tables/config.h"
#include "tables/formats.h"
#include "tests/support/oracle.h"

namespace feline {
namespace {

const Roms& machine() { return roms<kDefaultConfig>(); }

template <typename Expected>
void expect_words(const Rom& rom, const Expected& expected) {
  ASSERT_EQ(rom.words.size(), expected.size()) << rom.name;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(rom.words[i], static_cast<std::uint64_t>(expected[i])) << rom.name << " word " << i;
    EXPECT_EQ(rom.words[i] >> rom.data_bits, 0U) << rom.name << " word " << i << " is wider than its ROM";
  }
}

// The largest |word * 2^-fraction - real(i)| over words first .. and where.
template <typename Function>
void expect_error(const Rom& rom, int fraction_bits, std::size_t first, Function real) {
  double worst = 0;
  std::size_t where = 0;
  for (std::size_t i = first; i < rom.words.size(); ++i) {
    const double held = std::ldexp(static_cast<double>(rom.words[i]), -fraction_bits);
    const double error = abs(Real(held) - real(static_cast<long>(i))).to_double();
    if (error > worst * (1 + 1e-9)) {
      worst = error;
      where = i;
    }
  }
  EXPECT_NEAR(rom.worst_error, worst, 1e-6 * worst) << rom.name;
  EXPECT_EQ(rom.worst_word, where) << rom.name;
}

TEST(roms, gaussian) {
  expect_words(machine().gaussian, oracle::tables().gaussian);
  // exp(-d^2) of the distances x and 1 - x: a logistic function of 1 - 2x.
  expect_error(machine().gaussian, 8, 0,
               [](long i) { return Real(1) / (Real(1) + exp(Real(1) - Real::ratio(2 * i, 256))); });
}

TEST(roms, log2) {
  expect_words(machine().log2, oracle::tables().log2);
  expect_error(machine().log2, 8, 0, [](long i) { return log2(Real::ratio(256 + i, 256)); });
}

TEST(roms, reciprocal) {
  expect_words(machine().reciprocal, oracle::tables().reciprocal);
  expect_error(machine().reciprocal, 16, 1, [](long k) { return Real::ratio(1, k); });
}

TEST(roms, srgb) {
  expect_words(machine().srgb, oracle::tables().srgb);
  expect_error(machine().srgb, 4, 0, [](long code) {
    if (code <= 10) return Real::ratio(code * 255 * 100, 255 * 1292);
    return Real(255) * pow((Real::ratio(code, 255) + Real::ratio(11, 200)) / Real::ratio(211, 200), Real::ratio(12, 5));
  });
  // Known values: the ends, and 188, which is about half of the light.
  EXPECT_EQ(machine().srgb.words[0], 0U);
  EXPECT_EQ(machine().srgb.words[255], 255U * 16);
  EXPECT_NEAR(static_cast<double>(machine().srgb.words[188]) / (255 * 16), 0.5029, 2e-4);
}

TEST(roms, ellipse) {
  std::array<std::uint64_t, 256> words{};
  for (std::size_t i = 0; i < 256; ++i) {
    for (const long value : oracle::tables().ellipse[i / 16][i % 16])
      words[i] = words[i] << 8 | static_cast<std::uint64_t>(value);
  }
  expect_words(machine().ellipse, words);
  const EllipseEntry entry = ellipse_entry(kDefaultConfig, 0x81020c7f);
  EXPECT_EQ(entry.uv_scale, 0x81);
  EXPECT_EQ(entry.uv_scale_90, 0x02);
  EXPECT_EQ(entry.minor_radius, 0x0c);
  EXPECT_EQ(entry.major_radius, 0x7f);
}

// Erratum 2: columns 8 to 15 run from 90 degrees to 45. Minor radii grow with the angle, so they fall along them.
TEST(roms, ellipse_columns_run_as_erratum_2_says) {
  const auto minor = [](std::size_t row, std::size_t column) {
    return ellipse_entry(kDefaultConfig, machine().ellipse.words[row * 16 + column]).minor_radius;
  };
  for (std::size_t row = 1; row < 16; ++row) {
    for (std::size_t column = 0; column < 7; ++column) EXPECT_LE(minor(row, column), minor(row, column + 1)) << row;
    for (std::size_t column = 8; column < 15; ++column) EXPECT_GE(minor(row, column), minor(row, column + 1)) << row;
    EXPECT_GE(minor(row, 15), minor(row, 7)) << row;
  }
}

TEST(roms, weight) {
  std::array<long, 693> words{};
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = oracle::tables().weight[i / 9][i % 9];
  expect_words(machine().weight, words);
}

// The weight of column `column` at fProbes f, by Feline 3.1 and 3.2 in double precision.
double weight_at(double f, int probes, int column) {
  double sum = 0;
  double wanted = 0;
  for (int n = -(probes - 1); n <= probes - 1; n += 2) {
    const double d = probes == 1 ? 0 : n * (f - 1) / ((f + 1) * (probes - 1));
    const double weight = std::exp(-2 * d * d);
    sum += weight;
    if ((std::abs(n) + 1) / 2 == column) wanted = weight;
  }
  return wanted / sum;
}

// The stated error is the worst over all fProbes that a row serves, here on 1000 points a quarter: those for which plan
// chooses it, by either rounding of the probe count, ends included that are limits only.
TEST(roms, weight_error_over_all_that_rows_serve) {
  Rom rom = machine().weight;
  judge_weights(kDefaultConfig, rom);
  double worst = 0;
  std::size_t where = 0;
  const auto compare = [&](int row, int column, double real) {
    const auto word = static_cast<std::size_t>(9 * row + column);
    const double error = std::abs(static_cast<double>(rom.words[word]) / 256 - real);
    if (error < worst || (error == worst && word >= where)) return;
    worst = error;
    where = word;
  };
  for (int column = 0; column < 9; ++column) {
    for (int probes = 1; probes <= 16; ++probes) {
      if (oracle::weight_uses(probes, column) != 0) compare(60 + probes, column, 1.0 / probes);
    }
    for (int thousandths = 4000; thousandths <= 64000; ++thousandths) {
      const double f = thousandths / 4000.0;
      // Nearest, whose f is no more than its count once widened; and ceiling. An edge belongs to both of its quarters.
      for (const int probes : {static_cast<int>(std::floor(f + 0.5)), static_cast<int>(std::floor(f)) + 1}) {
        if (probes > 16 || oracle::weight_uses(probes, column) == 0) continue;
        const double served = std::min<double>(f, probes);
        for (const double quarters : {std::floor(4 * served), std::ceil(4 * served) - 1}) {
          const int row = std::clamp(static_cast<int>(quarters), 4 * probes - 3, 4 * probes) - 4;
          if (served == probes && row % 4 != 0) continue;
          compare(std::max(row, 0), column, weight_at(served, probes, column));
        }
      }
    }
  }
  EXPECT_NEAR(rom.worst_error, worst, 1e-9);
  EXPECT_EQ(rom.worst_word, where);
}

// Erratum 8: each row, by how often its probes use each column, sums to exactly one; unused columns hold 0.
TEST(roms, weight_rows_sum_to_one) {
  for (int row = 0; row < 77; ++row) {
    long sum = 0;
    for (int column = 0; column < 9; ++column) {
      const auto word = static_cast<long>(machine().weight.words[static_cast<std::size_t>(9 * row + column)]);
      const int uses = oracle::weight_uses(oracle::probes_of_row(row), column);
      sum += uses * word;
      EXPECT_TRUE(uses != 0 || word == 0) << row << " " << column;
    }
    EXPECT_EQ(sum, 256) << row;
  }
}

TEST(roms, no_probe_of_several_weighs_more_than_a_half) {
  for (int row = 0; row < 77; ++row) {
    if (oracle::probes_of_row(row) == 1) continue;
    for (int column = 0; column < 9; ++column) {
      EXPECT_LE(machine().weight.words[static_cast<std::size_t>(9 * row + column)], 128) << row << " " << column;
    }
  }
}

// How far the colour of a whole pixel is from that of weights that are not rounded, in codes of 255: the errors of a
// row's weights sum to 0, so it is farthest where all probes whose weight is too large meet white and the others black.
// The sum itself is exact and rounded once, to 1/256 of a code.
TEST(roms, weight_error_in_the_colour_of_a_pixel) {
  double worst = 0;
  int worst_row = 0;
  for (int row = 0; row < 77; ++row) {
    const int probes = oracle::probes_of_row(row);
    double too_large = 0;
    for (int column = 0; column < 9; ++column) {
      const auto at = static_cast<std::size_t>(column);
      const auto word = static_cast<double>(machine().weight.words[static_cast<std::size_t>(9 * row) + at]);
      const double error = word / 256 - oracle::tables().weight_real[static_cast<std::size_t>(row)][at];
      if (error > 0) too_large += oracle::weight_uses(probes, column) * error;
    }
    if (too_large > worst) {
      worst = too_large;
      worst_row = row;
    }
  }
  worst = 255 * worst + 1.0 / 512;
  const int probes = oracle::probes_of_row(worst_row);
  const std::string row = worst_row < 61 ? fmt::format("fProbes = {}", (worst_row + 4) / 4.0) : "equal weights";
  const std::string claim = fmt::format("within {:.2f} codes ({} probes, {})", worst, probes, row);
  std::ifstream readme(FELINE_SOURCE_DIR "/README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  EXPECT_NE(text.find(claim), std::string::npos) << claim;
}

// The least worst error that whole weights of sum 256 can have, by trying all of floor - 1 .. floor + 2.
double least_worst_error(int row) {
  const int probes = oracle::probes_of_row(row);
  const auto& real = oracle::tables().weight_real[static_cast<std::size_t>(row)];
  constexpr int kWide = 600;
  std::vector<double> best(kWide, 1e9);  // by sum
  best[0] = 0;
  for (int column = 0; column < 9; ++column) {
    const int uses = oracle::weight_uses(probes, column);
    if (uses == 0) continue;
    std::vector<double> next(kWide, 1e9);
    const double exact = real[static_cast<std::size_t>(column)] * 256;
    for (int off = -1; off <= 2; ++off) {
      const int weight = static_cast<int>(std::floor(exact)) + off;
      if (weight < 0) continue;
      for (int sum = 0; sum + uses * weight < kWide; ++sum) {
        auto& at = next[static_cast<std::size_t>(sum + uses * weight)];
        at = std::min(at, std::max(best[static_cast<std::size_t>(sum)], std::abs(weight - exact)));
      }
    }
    best = next;
  }
  return best[256] / 256;
}

// weights.cpp calls its rounding the one of least worst error.
TEST(roms, weight_rows_have_the_least_worst_error) {
  for (int row = 0; row < 77; ++row) {
    double worst = 0;
    for (int column = 0; column < 9; ++column) {
      if (oracle::weight_uses(oracle::probes_of_row(row), column) == 0) continue;
      const auto at = static_cast<std::size_t>(column);
      const auto word = static_cast<double>(machine().weight.words[static_cast<std::size_t>(9 * row) + at]);
      worst = std::max(worst, std::abs(word / 256 - oracle::tables().weight_real[static_cast<std::size_t>(row)][at]));
    }
    EXPECT_NEAR(worst, least_worst_error(row), 1e-6) << "row " << row;
  }
}

}  // namespace
}  // namespace feline
