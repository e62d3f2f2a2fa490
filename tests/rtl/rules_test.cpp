// SPDX-License-Identifier: Apache-2.0
// What the rules of mutants (testbench/mutation/rules) call illegal never comes, or a mutant that only such beats show
// would be called equivalent in vain.
#include <gtest/gtest.h>

#include "testbench/cosim/random_batches.h"
#include "tests/rtl/bench.h"
#include "tests/rtl/fault.h"
#include "tests/rtl/faulty_unit.h"
#include "tests/support/random.h"

namespace feline {
namespace {

// Illegal cycles of so many lookups, under conditions that vary.
std::uint64_t broken_rules(std::uint64_t lookups) {
  constexpr std::uint64_t kBatchLookups = 256;
  RandomBatches batches(seed(), kBatchLookups);
  batches.vary_conditions();
  Cosimulation simulation(make_faulty_unit, {5, 0.1, 1});
  take_broken_rules();
  for (std::uint64_t number = 0; number < lookups / kBatchLookups; ++number) {
    if (!simulation.run(batches.make(number, lookups))) {
      ADD_FAILURE() << "no batch but the first " << number << " was right";
      break;
    }
  }
  return take_broken_rules();
}

TEST(rules, every_beat_is_legal) { EXPECT_EQ(broken_rules(500000), 0U) << "FELINE_SEED=" << seed(); }

// Illegal cycles with a fault, nobody judging the beats.
std::uint64_t broken_with(std::string_view fault, const Lookup& lookup) {
  set_fault(fault.empty() ? 0 : find_fault(fault)->number);
  Bench bench(make_faulty_unit, lookup);
  take_broken_rules();
  bench.run(200, true, 4);
  set_fault(0);
  return take_broken_rules();
}

TEST(rules, a_mantissa_of_minus_128_is_counted) {
  // A largest derivative of 127.75 times a power of two, which rounds to 128.
  const Lookup lookup{0.5F, 0.5F, 127.75F / 128, 0, 0, 0.25F};
  EXPECT_EQ(broken_with("", lookup), 0U);
  EXPECT_GT(broken_with("overflow_of_rounding_missed", lookup), 0U);
}

TEST(rules, weights_that_do_not_sum_to_one_are_counted) {
  const Lookup lookup{0.5F, 0.5F, 1, 0, 0, 0.25F};
  EXPECT_EQ(broken_with("", lookup), 0U);
  EXPECT_GT(broken_with("column_one_low", lookup), 0U);
}

TEST(rules, a_flush_with_lookups_inside_is_counted) {
  Bench bench(make_faulty_unit);
  take_broken_rules();
  bench.run(40, false);
  EXPECT_EQ(take_broken_rules(), 0U);
  RtlUnit::Inputs inputs;
  inputs.flush = true;
  bench.unit->cycle(inputs);
  bench.unit->cycle({});
  EXPECT_GT(take_broken_rules(), 0U);
}

}  // namespace
}  // namespace feline
