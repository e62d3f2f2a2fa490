// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/float_patterns.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <set>

#include "testbench/cosim/random_batches.h"

namespace feline {
namespace {

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

TEST(float_patterns, every_sign_and_exponent_with_every_significand) {
  std::set<std::uint32_t> all;
  for (std::uint32_t i = 0; i < kFloatPatterns; ++i) all.insert(bits(float_pattern(i)));
  EXPECT_EQ(all.size(), kFloatPatterns);
  for (const std::uint32_t sign : {0U, 1U << 31}) {
    for (std::uint32_t exponent = 0; exponent < 256; ++exponent) {
      for (const std::uint32_t fraction : {0U, 1U, 1U << 22, (1U << 23) - 1, 3U, 3U << 21, 1U << 11, (1U << 12) - 1}) {
        EXPECT_TRUE(all.contains(sign | exponent << 23 | fraction)) << exponent << " " << fraction;
      }
    }
  }
}

// Every pattern meets every operand: the eighth lookups of a period are all of them.
TEST(float_patterns, every_operand_has_every_pattern_in_a_period) {
  constexpr std::uint64_t kBatch = 1 << 16;
  RandomBatches batches(3, kBatch);
  std::array<std::set<std::uint32_t>, 6> seen;
  constexpr std::uint64_t kLookups = RandomBatches::kPatternPeriod;
  for (std::uint64_t number = 0; number * kBatch < kLookups; ++number) {
    const Batch batch = batches.make(number, kLookups);
    for (std::size_t i = 7; i < batch.lookups.size(); i += 8) {
      const Lookup& lookup = batch.lookups[i];
      const float operands[] = {lookup.s, lookup.t, lookup.dsdx, lookup.dtdx, lookup.dsdy, lookup.dtdy};
      const std::uint64_t which = (batch.first_lookup + i) / 8 % 6;
      seen[which].insert(bits(operands[which]));
    }
  }
  for (const auto& patterns : seen) EXPECT_EQ(patterns.size(), kFloatPatterns);
}

}  // namespace
}  // namespace feline
