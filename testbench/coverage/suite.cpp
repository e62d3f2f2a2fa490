// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/suite.h"

#include <fmt/format.h>

#include <functional>
#include <numeric>
#include <tuple>

#include "tables/pack.h"
#include "testbench/cosim/random_batches.h"
#include "testbench/coverage/vast_batches.h"
#include "testbench/scenes/scene.h"

namespace feline::coverage {
namespace {

constexpr std::uint64_t kBatchLookups = 16;

class Runner {
 public:
  Runner(const CoveredUnit& covered, SuiteResult& result) : covered_(covered), result_(result) {}

  // Batches that follow each other without a reset, under one timing; the first comes with a reset.
  void start(const Timing& timing) {
    finish();
    simulation_ = std::make_unique<Cosimulation>(
        [this](std::uint64_t) { return std::make_unique<WatchedUnit>(*covered_.unit, result_.stalls); }, timing);
    result_.lookups.forget_mode();
  }

  void run(const Batch& batch, const std::string& what) {
    if (!result_.mismatch.empty()) return;
    if (!simulation_->run(batch)) {
      const Mismatch& found = *simulation_->mismatch();
      result_.mismatch =
          fmt::format("MISMATCH at stage {}, lookup {} of {}, probe {}, cycle {}{}{}\n", stage_name(found.stage),
                      found.lookup, what, found.probe, found.cycle, found.note.empty() ? "" : ": ", found.note);
      return;
    }
    result_.lookups.observe(batch);
  }

  void finish() {
    if (!simulation_) return;
    result_.beats = std::accumulate(simulation_->beats().begin(), simulation_->beats().end(), result_.beats);
    result_.cycles += simulation_->cycles();
    simulation_.reset();
  }

  // Offers lookups for some cycles, then leaves them inside: the next start resets the unit.
  void interrupt(const Batch& batch, int cycles, SplitMix64& random) {
    finish();
    WatchedUnit unit(*covered_.unit, result_.stalls);
    std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> sampler{};
    pack(batch.sampler, sampler);
    unit.set_sampler(sampler);
    RtlUnit::Inputs inputs;
    inputs.reset = true;
    unit.cycle(inputs);
    std::size_t next = 0;
    std::int64_t line = 0;
    inputs = {};
    for (int i = 0; i < cycles; ++i) {
      std::array<std::uint32_t, beat_words<RequestBeat<kUnit>>()> request{};
      pack(make_request<kUnit>(batch.lookups[next % batch.lookups.size()], 0), request);
      unit.set_request(request);
      if (inputs.memory_response_valid) unit.set_memory_response(batch.memory->line(line));
      inputs.request_valid = true;
      inputs.memory_request_ready = random.chance(0.3);
      inputs.accumulate_ready = random.chance(0.2);
      unit.cycle(inputs);
      const RtlUnit::Outputs outputs = unit.outputs();
      if (outputs.request_ready) ++next;
      inputs.memory_response_valid = outputs.memory_request_valid && inputs.memory_request_ready;
      line = outputs.memory_request_line;
    }
    result_.cycles += static_cast<std::uint64_t>(cycles);
  }

 private:
  const CoveredUnit& covered_;
  SuiteResult& result_;
  std::unique_ptr<Cosimulation> simulation_;
};

// A tag of any size.
Batch tagged(Batch batch, SplitMix64& random) {
  batch.first_lookup = random.next() >> 40;
  return batch;
}

void run_random(Runner& runner, SplitMix64& random, std::uint64_t seed, const Timing& timing, std::uint64_t count) {
  runner.start(timing);
  RandomBatches batches(seed, kBatchLookups);
  for (std::uint64_t number = 0; number < count; ++number) {
    runner.run(tagged(batches.make(number, count * kBatchLookups), random), "random lookups");
  }
}

void run_scenes(Runner& runner, SplitMix64& random) {
  constexpr int kSize = 12;
  runner.start({4, 0.05, 3});
  std::size_t number = 0;
  for (const Scene& scene : scenes()) {
    const Texture texture = scene.texture(MipFilter::kBox);
    const TextureMemory memory = layout_texture(texture);
    const GBuffer gbuffer = make_gbuffer(scene, kSize, kSize);
    SamplerOptions options;
    options.mode = number++ % 2 == 0 ? Mode::kTable : Mode::kSimple;
    runner.run(tagged({make_sampler<kUnit>(options, texture, memory), &memory, gbuffer.lookups, 0}, random),
               std::string(scene.name));
  }
}

// How far apart lookups come, and what they take.
struct Pace {
  double stalls;
  double request_stalls;
  double min_level;       // of the texture of 64 x 64: its level 4 is one line, its level 0 misses nearly always
  std::uint32_t longest;  // texels
};

// Lookups about as far apart as they take: they find the unit as often full as empty.
void run_paced(Runner& runner, SplitMix64& random, std::uint64_t seed) {
  constexpr int kSide = 64;
  constexpr std::size_t kLookups = 4000;
  constexpr std::array<Pace, 7> kPaces{{{0, 0.85, 4, 9},
                                        {0, 0.9, 4, 9},
                                        {0, 0.95, 4, 9},
                                        {0.9, 0.9, 4, 1},
                                        {0.95, 0.95, 4, 1},
                                        {0, 0.96, 0, 1},
                                        {0, 0, 0, 1}}};
  Texture texture{TexelFormat::kR8, false, {}};
  for (int side = kSide; side > 0; side /= 2) {
    texture.levels.push_back({side, side, std::vector<std::uint8_t>(static_cast<std::size_t>(side * side), 77)});
  }
  const TextureMemory memory = layout_texture(texture);
  for (const Pace& pace : kPaces) {
    SamplerOptions options;
    options.min_level = pace.min_level;
    std::vector<Lookup> lookups;
    for (std::size_t i = 0; i < kLookups; ++i) {
      const float longer = static_cast<float>(1 + random.below(pace.longest)) / kSide;
      lookups.push_back(
          {static_cast<float>(random.unit()), static_cast<float>(random.unit()), longer, 0, 0, 1.0F / kSide});
    }
    const Timing timing{1, pace.stalls, seed};
    Batch batch{make_sampler<kUnit>(options, texture, memory), &memory, lookups};
    batch.conditions = timing.conditions();
    batch.conditions->at(Port::kRequest).chance = pace.request_stalls;
    runner.start(timing);
    runner.run(tagged(batch, random), "paced lookups");
  }
}

void run_resets(Runner& runner, SplitMix64& random, std::uint64_t seed) {
  constexpr int kTimes = 60;
  RandomBatches batches(seed, kBatchLookups);
  for (int i = 0; i < kTimes; ++i) {
    runner.interrupt(batches.make(static_cast<std::uint64_t>(i), kTimes * kBatchLookups), 5 + 7 * i, random);
    runner.start({2, 0, seed});
    runner.run(batches.make(static_cast<std::uint64_t>(i), kTimes * kBatchLookups), "lookups after a reset");
  }
}

// Of many random lookups those by which a bin is reached that was not before.
void run_chosen(Runner& runner, SplitMix64& random, std::uint64_t seed, LookupBins bins) {
  constexpr std::uint64_t kBatches = 3000;
  constexpr std::uint64_t kLookups = 64;
  runner.start({1, 0, seed});
  RandomBatches batches(seed, kLookups);
  for (std::uint64_t number = 0; number < kBatches; ++number) {
    Batch batch = batches.make(number, kBatches * kLookups);
    std::vector<Lookup> chosen;
    for (const Lookup& lookup : batch.lookups) {
      if (bins.observe(lookup, batch.sampler, *batch.memory)) chosen.push_back(lookup);
    }
    if (chosen.empty()) continue;
    batch.lookups = chosen;
    batch.same_texture_follows = false;  // the next may not be run
    runner.run(tagged(batch, random), "chosen lookups");
  }
}

void run_vast(Runner& runner, SplitMix64& random, std::uint64_t seed) {
  using enum VastBatches::Choice;
  constexpr std::size_t kLookups = 8;
  VastBatches batches(seed);
  runner.start({1, 0, seed});
  for (const auto& [choice, count, what] :
       {std::tuple{kAny, 800, "lookups in large textures"}, std::tuple{kBorder, 500, "lookups around borders"},
        std::tuple{kThin, 5000, "lookups in thin textures"}}) {
    for (int number = 0; number < count; ++number) {
      runner.run(tagged(batches.make(choice, kLookups), random), what);
    }
  }
}

}  // namespace

SuiteResult run_suite(const CoveredUnit& covered, std::uint64_t seed) {
  SuiteResult result;
  Runner runner(covered, result);
  SplitMix64 random(derived_seed(seed, 0));
  run_random(runner, random, derived_seed(seed, 1), {1, 0, seed}, 40);
  runner.finish();
  if (!result.mismatch.empty()) return result;
  covered.forget();
  result = {};
  const auto random_of = [&](std::uint64_t part, const Timing& timing, std::uint64_t count) {
    return [&, part, timing, count] { run_random(runner, random, derived_seed(seed, part), timing, count); };
  };
  const std::vector<std::function<void()>> parts{
      [&] { run_vast(runner, random, derived_seed(seed, 2)); },
      random_of(3, {1, 0, seed}, 600),
      random_of(4, {3, 0.1, seed}, 150),
      random_of(5, {2, 0.6, seed}, 150),
      random_of(6, {20, 0.9, seed}, 40),
      random_of(7, {1, 0.8, seed}, 150),
      random_of(8, {1, 0.9, seed}, 80),
      random_of(9, {60, 0.2, seed}, 20),
      [&] { run_paced(runner, random, seed); },
      [&] { run_scenes(runner, random); },
      [&] { run_chosen(runner, random, derived_seed(seed, 10), result.lookups); },
      [&] { run_resets(runner, random, derived_seed(seed, 11)); }};
  for (const auto& part : parts) {
    if (result.mismatch.empty()) part();
  }
  runner.finish();
  return result;
}

}  // namespace feline::coverage
