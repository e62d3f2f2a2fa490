// SPDX-License-Identifier: Apache-2.0
// What the rules of mutants (testbench/mutation/rules) call illegal never comes, or a mutant that only such beats show
// would be called equivalent in vain.
#include <gtest/gtest.h>

#include "testbench/cosim/random_batches.h"
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
    if (!simulation.run(batches.make(number, lookups))) break;
  }
  return take_broken_rules();
}

TEST(rules, every_beat_is_legal) { EXPECT_EQ(broken_rules(500000), 0U) << "FELINE_SEED=" << seed(); }

TEST(rules, what_is_illegal_is_counted) {
  set_fault(find_fault("overflow_of_rounding_missed")->number);
  EXPECT_GT(broken_rules(20000), 0U);
  set_fault(0);
}

}  // namespace
}  // namespace feline
