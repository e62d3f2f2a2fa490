// SPDX-License-Identifier: Apache-2.0
#include "model/walk.h"

#include <gtest/gtest.h>

#include "tests/support/describe.h"
#include "tests/support/oracle.h"
#include "tests/support/random_beat.h"

namespace feline {
namespace {

int rows_of(int probes) { return probes == 1 ? 1 : 4; }

// 1,000,000 plans of any positions and steps, with the rows that plan gives to their probe counts.
TEST(walk, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_walk.equals_exact_arithmetic");
  for (int i = 0; i < 1000000; ++i) {
    PlanBeat<kDefaultConfig> plan;
    draw_what_is_handed_on(random, plan);
    draw(random, plan.s);
    draw(random, plan.t);
    draw(random, plan.half_step_s);
    draw(random, plan.half_step_t);
    const int probes = static_cast<int>(random.between(1, 16));
    plan.probes = plan.probes.from_raw(probes);
    const bool equal = random.one_in(4);
    plan.weight_row =
        plan.weight_row.from_raw(equal ? 60 + probes : std::max(0, 4 * probes - 7) + random.below(rows_of(probes)));
    draw(random, plan.level_of_detail);
    draw(random, plan.linear);
    const int probe = static_cast<int>(random.below(probes));
    const auto got = walk<kDefaultConfig>(plan, probe);
    const auto want = oracle::walk(plan, probe);
    ASSERT_TRUE(same(got, want)) << mismatch(got, want, plan);
  }
}

// Invariant 6 for every row that a probe count can have, and symmetry about the middle.
TEST(walk, weights_of_every_row_sum_to_one) {
  int rows = 0;
  for (int probes = 1; probes <= 16; ++probes) {
    std::vector<int> candidates{60 + probes};
    for (int k = 0; k < rows_of(probes); ++k) candidates.push_back(std::max(0, 4 * probes - 7) + k);
    for (const int row : candidates) {
      PlanBeat<kDefaultConfig> plan;
      plan.probes = plan.probes.from_raw(probes);
      plan.weight_row = plan.weight_row.from_raw(row);
      std::int64_t sum = 0;
      for (int i = 0; i < probes; ++i) {
        const auto weight = walk<kDefaultConfig>(plan, i).weight.raw();
        EXPECT_EQ(weight, (walk<kDefaultConfig>(plan, probes - 1 - i).weight.raw())) << row;
        EXPECT_GT(weight, 0) << row;
        sum += weight;
      }
      EXPECT_EQ(sum, 256) << row;
      ++rows;
    }
  }
  EXPECT_EQ(rows, 77);
}

// Figures 10 and 11: an even number of probes at odd half steps, an odd number at even ones.
TEST(walk, positions_of_even_and_odd_counts) {
  PlanBeat<kDefaultConfig> plan;
  plan.s = plan.s.from_raw(1000);
  plan.half_step_s = plan.half_step_s.from_raw(10);
  const auto positions = [&](int probes) {
    plan.probes = plan.probes.from_raw(probes);
    std::vector<std::int64_t> at;
    for (int i = 0; i < probes; ++i) at.push_back(walk<kDefaultConfig>(plan, i).s.raw());
    return at;
  };
  EXPECT_EQ(positions(1), (std::vector<std::int64_t>{1000}));
  EXPECT_EQ(positions(4), (std::vector<std::int64_t>{970, 990, 1010, 1030}));
  EXPECT_EQ(positions(5), (std::vector<std::int64_t>{960, 980, 1000, 1020, 1040}));
}

}  // namespace
}  // namespace feline
