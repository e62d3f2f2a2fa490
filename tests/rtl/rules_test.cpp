// SPDX-License-Identifier: Apache-2.0
// What the rules of mutants (testbench/mutation/rules) call illegal never comes, or a mutant that only such beats show
// would be called equivalent in vain.
#include <gtest/gtest.h>

#include "tables/pack.h"
#include "testbench/cosim/random_batches.h"
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
  const std::unique_ptr<RtlUnit> unit = make_faulty_unit(1);
  const std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> no_size{};
  unit->set_sampler(no_size);
  RtlUnit::Inputs inputs;
  inputs.reset = true;
  unit->cycle(inputs);
  take_broken_rules();
  unit->cycle({});
  unit->cycle({});
  EXPECT_GE(take_broken_rules(), 4U) << "group, footprint, plan and address";
}

}  // namespace
}  // namespace feline
