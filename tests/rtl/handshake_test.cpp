// SPDX-License-Identifier: Apache-2.0
// The stream rules that random stalls cannot show: valid does not wait for ready.
#include <gtest/gtest.h>

#include "model/sampler.h"
#include "tables/pack.h"
#include "testbench/cosim/cosimulation.h"

namespace feline {
namespace {

constexpr int kLongEnough = 100;

struct Bench {
  Texture texture{TexelFormat::kR8, false, {{4, 4, std::vector<std::uint8_t>(16, 77)}}};
  TextureMemory memory = layout_texture(texture);
  std::unique_ptr<RtlUnit> unit = make_fast_unit(1);

  Bench() {
    std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> sampler{};
    pack(make_sampler<kUnit>({}, texture, memory), sampler);
    unit->set_sampler(sampler);
    RtlUnit::Inputs inputs;
    inputs.reset = true;
    unit->cycle(inputs);
    unit->cycle(inputs);
    std::array<std::uint32_t, beat_words<RequestBeat<kUnit>>()> request{};
    pack(make_request<kUnit>({0.5F, 0.5F, 0.1F, 0, 0, 0.1F}, 1), request);
    unit->set_request(request);
    unit->set_memory_response(memory.line(0));
  }

  // Offers one request, answers memory if asked to, and never takes a pixel.
  RtlUnit::Outputs run(int cycles, bool memory_ready) {
    RtlUnit::Outputs outputs;
    RtlUnit::Inputs inputs;
    bool offered = false;
    for (int i = 0; i < cycles; ++i) {
      inputs.request_valid = !offered;
      inputs.memory_request_ready = memory_ready;
      unit->cycle(inputs);
      outputs = unit->outputs();
      offered = offered || outputs.request_ready;
      inputs.memory_response_valid = memory_ready && outputs.memory_request_valid;
    }
    return outputs;
  }
};

// A reset at any moment, reads outstanding or a pixel on offer, and the next lookup is as the first ever.
TEST(handshake, reset_at_any_cycle_forgets_everything) {
  for (int cycles = 0; cycles < kLongEnough; ++cycles) {
    for (const bool memory_ready : {false, true}) {
      Bench bench;
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
  Bench bench;
  const RtlUnit::Outputs outputs = bench.run(kLongEnough, false);
  EXPECT_TRUE(outputs.memory_request_valid);
  EXPECT_TRUE(outputs.busy);
  EXPECT_FALSE(outputs.accumulate_valid);
}

TEST(handshake, pixel_does_not_wait_for_ready) {
  Bench bench;
  const RtlUnit::Outputs outputs = bench.run(kLongEnough, true);
  EXPECT_TRUE(outputs.accumulate_valid);
  EXPECT_TRUE(outputs.busy);
  const auto pixel = unpack<AccumulateBeat<kUnit>>(bench.unit->beat(Stage::kAccumulate));
  EXPECT_EQ(pixel.colour[0].value(), 77);
  EXPECT_EQ(pixel.tag.raw(), 1);
}

}  // namespace
}  // namespace feline
