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

// What is illegal among so many lookups, under conditions that vary.
BrokenRules broken_rules(std::uint64_t lookups) {
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

TEST(rules, every_beat_is_legal) { EXPECT_EQ(broken_rules(500000), BrokenRules{}) << "FELINE_SEED=" << seed(); }

// What is illegal with a fault, nobody judging the beats.
BrokenRules broken_with(std::string_view fault, const Lookup& lookup) {
  set_fault(fault.empty() ? 0 : find_fault(fault)->number);
  Bench bench(make_faulty_unit, lookup);
  take_broken_rules();
  bench.run(200, true, 4);
  set_fault(0);
  return take_broken_rules();
}

// A rule that nobody watches would be broken by no fault.
void expect_counted(const std::string& stage, std::string_view fault, const Lookup& lookup) {
  EXPECT_EQ(broken_with("", lookup), BrokenRules{}) << fault;
  EXPECT_GT(broken_with(fault, lookup)[stage], 0U) << fault;
}

TEST(rules, a_fault_before_a_stage_is_counted_there) {
  // A largest derivative of 127.75 times a power of two, which rounds to 128: a mantissa of -128.
  expect_counted("footprint", "overflow_of_rounding_missed", {0.5F, 0.5F, 127.75F / 128, 0, 0, 0.25F});
  // A radius below that of the least mantissa.
  expect_counted("plan", "length_takes_smaller_part", {0.5F, 0.5F, 1, 0, 0, 0.25F});
  // 17 of 16 probes; a level past the last.
  expect_counted("walk", "one_probe_too_many", {0.5F, 0.5F, 8, 0, 0, 0.25F});
  expect_counted("address", "last_level_unseen", {0.5F, 0.5F, 1, 0, 0, 1});
  // Weights that do not sum to one.
  expect_counted("accumulate", "column_one_low", {0.5F, 0.5F, 1, 0, 0, 0.25F});
}

TEST(rules, a_flush_with_lookups_inside_is_counted) {
  Bench bench(make_faulty_unit);
  take_broken_rules();
  bench.run(40, false);
  EXPECT_EQ(take_broken_rules(), BrokenRules{});
  RtlUnit::Inputs inputs;
  inputs.flush = true;
  bench.unit->cycle(inputs);
  bench.unit->cycle({});
  EXPECT_GT(take_broken_rules()["fetch"], 0U);
}

// A request that another one takes the place of before it is taken; a sampler state without a size.
TEST(rules, what_a_driver_may_not_do_is_counted) {
  Bench bench(make_faulty_unit);
  take_broken_rules();
  bench.run(200, false, 100);
  EXPECT_EQ(take_broken_rules(), BrokenRules{});
  std::array<std::uint32_t, beat_words<RequestBeat<kUnit>>()> request{};
  pack(make_request<kUnit>({0.25F, 0.5F, 0.1F, 0, 0, 0.1F}, 2), request);
  bench.unit->set_request(request);
  RtlUnit::Inputs inputs;
  inputs.request_valid = true;
  bench.unit->cycle(inputs);
  bench.unit->cycle(inputs);
  EXPECT_EQ(take_broken_rules(), (BrokenRules{{"group", 1}}));
  const std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> nothing{};
  bench.unit->set_sampler(nothing);
  for (int i = 0; i < 3; ++i) bench.unit->cycle({});
  const BrokenRules broken = take_broken_rules();
  for (const char* const stage : {"group", "footprint", "plan", "address", "fetch"})
    EXPECT_TRUE(broken.contains(stage));
}

}  // namespace
}  // namespace feline
