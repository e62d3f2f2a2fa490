// SPDX-License-Identifier: Apache-2.0
// How an ellipse entry stands for its cell: the measurement behind the choice, made again in double precision by the
// paper's formulas, and compared with the table's own judge.
#include "testbench/ellipse_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tables/config.h"
#include "tables/roms.h"
#include "tests/support/oracle.h"

namespace feline {
namespace {

struct Judgement {
  EllipseErrors errors;
  double worst_value = 0;
};

// Lattice of (steps + 1)^2 points a cell; at most 16 probes.
Judgement judge(const Rom& rom, int steps) {
  Judgement judged;
  double points = 0;
  const auto outcome = [](const std::array<double, 4>& scale) {
    const double minor = std::max(scale[2], 2 * scale[3] / 17);
    const double along = 1 - minor / scale[3];
    return std::array{minor, scale[3], scale[0] * along, scale[1] * along};
  };
  for (std::size_t word = 0; word < 256; ++word) {
    const auto e = ellipse_entry(kDefaultConfig, rom.words[word]);
    const std::array<double, 4> held{static_cast<double>(e.uv_scale) / 128, static_cast<double>(e.uv_scale_90) / 256,
                                     static_cast<double>(e.minor_radius) / 256,
                                     static_cast<double>(e.major_radius) / 128};
    const auto got = outcome(held);
    const auto row = static_cast<int>(word / 16);
    for (int x = 0; x <= steps; ++x) {
      for (int y = 0; y <= steps; ++y) {
        const double ratio = (row + static_cast<double>(x) / steps) / 16;
        const double angle = oracle::cell_angle(static_cast<int>(word % 16), static_cast<double>(y) / steps);
        const auto real = oracle::ellipse(ratio, angle);
        const auto want = outcome(real);
        for (std::size_t i = 0; i < 4; ++i)
          judged.worst_value = std::max(judged.worst_value, std::abs(held[i] - real[i]));
        const double level = std::abs(std::log2(got[0] / want[0]));
        const double major = std::abs(got[1] / want[1] - 1);
        const double line = std::hypot(got[2] - want[2], got[3] - want[3]) / want[0];
        auto& errors = judged.errors;
        errors.worst_level = std::max(errors.worst_level, level);
        errors.worst_major = std::max(errors.worst_major, major);
        errors.worst_line = std::max(errors.worst_line, line);
        errors.mean_level += level;
        errors.mean_major += major;
        errors.mean_line += line;
        ++points;
      }
    }
  }
  judged.errors.mean_level /= points;
  judged.errors.mean_major /= points;
  judged.errors.mean_line /= points;
  return judged;
}

constexpr int kSteps = 32;  // as the generator

Judgement judge(CellRepresentation representation) {
  return judge(ellipse_rom(kDefaultConfig, representation), kSteps);
}

TEST(ellipse_choice, judge_agrees_with_the_papers_formulas) {
  Rom rom = ellipse_rom(kDefaultConfig);
  judge_ellipse(kDefaultConfig, rom);
  const EllipseErrors stated = ellipse_errors(kDefaultConfig, rom, kSteps);
  const Judgement found = judge(rom, kSteps);
  EXPECT_NEAR(rom.worst_error, found.worst_value, 1e-6 * found.worst_value);
  EXPECT_NEAR(stated.worst_level, found.errors.worst_level, 1e-6);
  EXPECT_NEAR(stated.mean_level, found.errors.mean_level, 1e-6);
  EXPECT_NEAR(stated.worst_major, found.errors.worst_major, 1e-6);
  EXPECT_NEAR(stated.mean_major, found.errors.mean_major, 1e-6);
  // At the circle the axis is anybody's: one point of the lattice may differ by all of it.
  EXPECT_NEAR(stated.mean_line, found.errors.mean_line, 1e-5);
  EXPECT_DOUBLE_EQ(rom.worst_error, 0.4609375);
}

// The choice: the worst level error of the mean is less than that of the least worst case's entry, its mean error is
// no more than 0.1 % from the best, and the centre is worse.
TEST(ellipse_choice, mean_of_the_cell_is_the_best) {
  const EllipseErrors centre = judge(CellRepresentation::kCentre).errors;
  const EllipseErrors worst = judge(CellRepresentation::kLeastWorst).errors;
  const EllipseErrors mean = judge(CellRepresentation::kLeastMean).errors;
  for (const auto& [name, e] : {std::pair{"centre", centre}, {"least worst", worst}, {"least mean", mean}}) {
    std::printf("%-12s level worst %.4f mean %.5f octaves; major worst %.4f mean %.5f; line worst %.4f mean %.5f\n",
                name, e.worst_level, e.mean_level, e.worst_major, e.mean_major, e.worst_line, e.mean_line);
  }
  EXPECT_NEAR(mean.worst_level, 0.3424, 5e-5);
  const double least_mean = std::min({centre.mean_level, worst.mean_level, mean.mean_level});
  EXPECT_LE(mean.mean_level, 1.001 * least_mean);
  EXPECT_LE(mean.worst_level, centre.worst_level);
  EXPECT_LE(mean.worst_level, worst.worst_level);
}

}  // namespace
}  // namespace feline
