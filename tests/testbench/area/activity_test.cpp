// SPDX-License-Identifier: Apache-2.0
// Toggles: none without work, none for waiting, twice as many for twice the work.
#include "testbench/area/activity.h"

#include <gtest/gtest.h>

#include "tables/emit.h"
#include "tables/pack.h"
#include "testbench/random.h"
#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

// Footprints of several probes over a texture with something on it.
struct Scenery {
  Texture texture{TexelFormat::kR8, false, {{8, 8, std::vector<std::uint8_t>(64)}}};
  TextureMemory memory;
  SamplerState<kUnit> sampler;
  std::vector<Lookup> lookups;

  explicit Scenery(int count) {
    for (std::size_t i = 0; i < 64; ++i) texture.levels.front().texels[i] = static_cast<std::uint8_t>(37 * i);
    memory = layout_texture(texture);
    sampler = make_sampler<kUnit>({}, texture, memory);
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<float>(i % 16) / 16;
      lookups.push_back({at, 1 - at, 0.5F, 0.25F, 0.01F, 0.03F * at});
    }
  }
  Activity measure(const Timing& timing) const {
    return measure_activity({sampler, &memory, lookups, 0}, timing, make_trace_unit, nullptr);
  }
};

TEST(activity, of_a_unit_without_requests_is_nothing) {
  const Scenery scenery(1);
  const TempDir directory;
  const std::filesystem::path wave = directory / "idle.fst";
  {
    const auto unit = make_trace_unit(1);
    std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> sampler{};
    pack(scenery.sampler, sampler);
    unit->set_sampler(sampler);
    RtlUnit::Inputs inputs;
    inputs.reset = true;
    unit->cycle(inputs);
    unit->cycle(inputs);
    unit->open_wave(wave);
    SplitMix64 random(1);
    std::array<std::uint32_t, beat_words<RequestBeat<kUnit>>()> request{};
    for (int i = 0; i < 50; ++i) {
      // What is on the data pins of an idle unit means nothing, and moves no register.
      for (std::uint32_t& word : request) word = static_cast<std::uint32_t>(random.next());
      unit->set_request(request);
      unit->set_memory_response(scenery.memory.line(i % 4));
      inputs = {};
      inputs.accumulate_ready = i % 2 != 0;
      inputs.memory_request_ready = i % 3 != 0;
      unit->cycle(inputs);
    }
  }
  const std::vector<StageToggles> stages = count_toggles(wave);
  ASSERT_EQ(stages.size(), 10U);
  for (const StageToggles& stage : stages) {
    EXPECT_EQ(stage.registers, 0U) << stage.stage;
    EXPECT_EQ(stage.memories, 0U) << stage.stage;
  }
}

TEST(activity, scales_with_pixels_and_not_with_waiting) {
  const Activity once = Scenery(32).measure({});
  const Activity twice = Scenery(64).measure({});
  Timing slow;
  slow.memory_latency = 200;
  slow.stalls = 0.5;
  const Activity waiting = Scenery(64).measure(slow);
  EXPECT_EQ(once.lookups, 32U);
  EXPECT_EQ(twice.probes, 2 * once.probes);
  EXPECT_GT(waiting.cycles, 3 * twice.cycles);
  for (std::size_t i = 0; i < once.stages.size(); ++i) {
    const auto registers = [&](const Activity& of) { return static_cast<double>(of.stages[i].registers); };
    if (once.stages[i].stage == "rest") continue;
    EXPECT_GT(registers(once), 1000) << once.stages[i].stage;
    EXPECT_NEAR(registers(twice) / registers(once), 2, 0.3) << once.stages[i].stage;
    // A stall moves some valid bits, and sends beats through the spill register's second half.
    EXPECT_NEAR(registers(waiting) / registers(twice), 1, once.stages[i].stage == "spill" ? 1 : 0.1)
        << once.stages[i].stage;
  }
}

TEST(activity, survives_json) {
  Activity activity = Scenery(4).measure({});
  const Activity again = activity_from_json(to_json(activity));
  EXPECT_EQ(to_json(again), to_json(activity));
  EXPECT_EQ(again.stages.size(), 10U);
  add(activity, again);
  EXPECT_EQ(activity.cycles, 2 * again.cycles);
  EXPECT_EQ(activity.stages[3].nets, 2 * again.stages[3].nets);
}

TEST(activity, refuses_what_is_no_waveform) {
  const TempDir directory;
  write_bytes(directory / "not.fst", "no waveform");
  EXPECT_NE(input_error([&] { count_toggles(directory / "not.fst"); }).find("not.fst: open: got no waveform"),
            std::string::npos);
}

TEST(activity, program_prints_every_stage) {
  const Outcome outcome = run_program(FELINE_PROGRAM, "activity --scene bricks --size 8 --memory-latency 3");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  for (const char* const name :
       {"group", "footprint", "plan", "walk", "spill", "address", "fetch", "filter", "accumulate", "all"}) {
    EXPECT_NE(outcome.text.find(std::string("\n") + name), std::string::npos) << name;
  }
  EXPECT_NE(outcome.text.find("64 pixels"), std::string::npos);
  EXPECT_EQ(run_program(FELINE_PROGRAM, "activity --unit /nonexistent").code, 2);
  EXPECT_EQ(run_program(FELINE_PROGRAM, "activity --stalls 2").code, 2);
}

}  // namespace
}  // namespace feline
