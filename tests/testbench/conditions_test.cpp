// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/conditions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace feline {
namespace {

TEST(conditions, a_port_waits_as_long_as_its_pattern_says) {
  constexpr int kCycles = 200000;
  for (const StallPattern& pattern : {StallPattern{0, 1}, StallPattern{0.3, 1}, StallPattern{0.05, 20}}) {
    StallSource source(pattern, 1);
    int transfers = 0;
    std::uint32_t run = 0;
    std::uint32_t longest = 0;
    for (int i = 0; i < kCycles; ++i) {
      const bool stalls = source.stalls();
      transfers += stalls ? 0 : 1;
      run = stalls ? run + 1 : 0;
      longest = std::max(longest, run);
    }
    EXPECT_NEAR(static_cast<double>(kCycles) / transfers, pattern.cycles(), 0.03 * pattern.cycles());
    EXPECT_GE(longest, pattern.chance == 0 ? 0 : pattern.longest);
  }
}

TEST(conditions, every_kind_occurs) {
  SplitMix64 random(1);
  int longest_latency = 0;
  int at_once = 0;
  int resets = 0;
  std::array<int, kPortCount> stalled{};
  for (int i = 0; i < 5000; ++i) {
    const Conditions conditions = random_conditions(random);
    ASSERT_GE(conditions.memory_latency, 0);
    ASSERT_LE(conditions.memory_latency, 1000);
    longest_latency = std::max(longest_latency, conditions.memory_latency);
    at_once += conditions.memory_latency == 0 ? 1 : 0;
    resets += conditions.resets != 0 ? 1 : 0;
    for (std::size_t port = 0; port < kPortCount; ++port) stalled[port] += conditions.stalls[port].chance != 0 ? 1 : 0;
  }
  EXPECT_GT(longest_latency, 500);
  EXPECT_NEAR(at_once, 1050, 150);
  EXPECT_NEAR(resets, 1250, 150);
  for (const int count : stalled) EXPECT_GT(count, 800);
}

}  // namespace
}  // namespace feline
