// SPDX-License-Identifier: Apache-2.0
// The stream rules that random stalls cannot show: valid does not wait for ready.
#include <gtest/gtest.h>

#include "tests/rtl/bench.h"

namespace feline {
namespace {

constexpr int kLongEnough = 100;

// A reset at any moment, reads outstanding or a pixel on offer, and the next lookup is as the first ever.
TEST(handshake, reset_at_any_cycle_forgets_everything) {
  for (int cycles = 0; cycles < kLongEnough; ++cycles) {
    for (const bool memory_ready : {false, true}) {
      Bench bench(make_fast_unit);
      bench.run(cycles, memory_ready);
      RtlUnit::Inputs inputs;
      inputs.reset = true;
      bench.unit->cycle(inputs);
      EXPECT_FALSE((bench.unit->cycle({}), bench.unit->outputs()).busy) << cycles;
      const RtlUnit::Outputs outputs = bench.run(kLongEnough, true);
      ASSERT_TRUE(outputs.accumulate_valid) << cycles;
      const auto pixel = unpack<AccumulateBeat<kUnit>>(bench.unit->beat(Stage::kAccumulate));
      EXPECT_EQ(pixel.colour[0].value(), 77) << cycles;
      // It was the only one.
      inputs = {};
      inputs.accumulate_ready = true;
      bench.unit->cycle(inputs);
      for (int i = 0; i < kLongEnough; ++i) {
        bench.unit->cycle(inputs);
        ASSERT_FALSE(bench.unit->outputs().accumulate_valid) << cycles;
        ASSERT_FALSE(bench.unit->outputs().busy) << cycles;
      }
    }
  }
}

TEST(handshake, memory_request_does_not_wait_for_ready) {
  Bench bench(make_fast_unit);
  const RtlUnit::Outputs outputs = bench.run(kLongEnough, false);
  EXPECT_TRUE(outputs.memory_request_valid);
  EXPECT_TRUE(outputs.busy);
  EXPECT_FALSE(outputs.accumulate_valid);
}

TEST(handshake, pixel_does_not_wait_for_ready) {
  Bench bench(make_fast_unit);
  const RtlUnit::Outputs outputs = bench.run(kLongEnough, true);
  EXPECT_TRUE(outputs.accumulate_valid);
  EXPECT_TRUE(outputs.busy);
  const auto pixel = unpack<AccumulateBeat<kUnit>>(bench.unit->beat(Stage::kAccumulate));
  EXPECT_EQ(pixel.colour[0].value(), 77);
  EXPECT_EQ(pixel.tag.raw(), 1);
}

}  // namespace
}  // namespace feline
