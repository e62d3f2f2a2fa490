// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/cosimulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tables/emit.h"
#include "testbench/cosim/memory_model.h"

namespace feline {

Cosimulation::Cosimulation(const RtlFactory& factory, const Timing& timing)
    : timing_(timing), unit_(factory(timing.seed)) {
  if (unit_->fingerprint() != fingerprint<kUnit>()) {
    throw std::runtime_error(
        fmt::format("stale build: the RTL's fingerprint is {:016x}, the model's is {:016x}; run ./testbench/generate "
                    "and build again",
                    unit_->fingerprint(), fingerprint<kUnit>()));
  }
}

void Cosimulation::wave_cycle() {
  if (!wave_) return;
  if (cycle_ == wave_->first_cycle) unit_->open_wave(wave_->path);
  if (cycle_ == wave_->last_cycle + 1) unit_->close_wave();
}

Conditions Timing::conditions() const {
  Conditions all;
  all.memory_latency = memory_latency;
  all.stalls.fill({stalls, 1});
  return all;
}

void Cosimulation::begin(const Batch& batch) {
  std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> sampler{};
  pack(batch.sampler, sampler);
  unit_->set_sampler(sampler);
  const bool first = batches_++ == 0;
  const bool follows = std::exchange(same_texture_, batch.same_texture_follows);
  // Reset at power-up; afterwards a batch only forgets the lines of the texture before it.
  const bool resets = first || batch.begins_with_reset;
  for (int i = 0; i < 2 && (first || !follows); ++i) {
    wave_cycle();
    RtlUnit::Inputs inputs;
    inputs.reset = resets;
    inputs.flush = !resets;
    unit_->cycle(inputs);
    ++cycle_;
  }
}

// In the midst of a batch: whatever is inside is gone.
void Cosimulation::reset() {
  wave_cycle();
  RtlUnit::Inputs inputs;
  inputs.reset = inputs.request_valid = inputs.accumulate_ready = inputs.memory_request_ready = true;
  unit_->cycle(inputs);
  ++cycle_;
  ++resets_;
  scoreboard_.forget();
  inside_ = 0;
  held_ = {};
}

bool Cosimulation::fail(Stage stage, std::string note) {
  if (!protocol_) {
    protocol_ = Mismatch{
        Mismatch::Kind::kProtocol, stage, scoreboard_.nearest_lookup(stage), 0, cycle_, {}, {}, std::move(note)};
  }
  return false;
}

// What is offered stays until it is taken, at every boundary.
bool Cosimulation::check_protocol(const RtlUnit::Outputs& outputs, const RtlUnit::Inputs& inputs) {
  if (held_.memory_request_valid &&
      (!outputs.memory_request_valid || outputs.memory_request_line != held_.memory_request_line)) {
    return fail(Stage::kFetch, "a memory request changed or went away before it was taken");
  }
  if (inputs.memory_response_valid && !outputs.memory_response_ready) {
    return fail(Stage::kFetch, "a memory response is not taken in the cycle in which it comes");
  }
  for (std::size_t index = 0; index < kStageCount; ++index) {
    const auto stage = static_cast<Stage>(index);
    const bool offered = (outputs.offered >> index & 1) != 0;
    const bool was_held = (held_.offered >> index & 1) != 0;
    if (!offered && !was_held) continue;
    const auto beat = unit_->beat(stage);
    if (was_held && (!offered || !std::ranges::equal(beat, held_beats_[index]))) {
      return fail(stage, "a beat changed or went away before it was taken");
    }
    if (!was_held) held_beats_[index].assign(beat.begin(), beat.end());
  }
  held_.offered = outputs.offered & ~outputs.taken;
  held_.memory_request_valid = outputs.memory_request_valid && !inputs.memory_request_ready;
  held_.memory_request_line = outputs.memory_request_line;
  return true;
}

bool Cosimulation::check_busy(const RtlUnit::Outputs& outputs, std::uint64_t entered) {
  if (outputs.busy == (inside_ != 0)) return true;
  // Whoever counts no more than can be inside (MostInFlight of feline_unit), and rightly so, counts wrong when lookups
  // get lost, which is the fault.
  constexpr std::uint64_t kMany = 24;
  if (inside_ > kMany && scoreboard_.blame_stopped(outputs.offered, entered, cycle_)) return false;
  return fail(Stage::kGroup, "busy_o does not say whether lookups are inside");
}

// When all pixels are out nothing may follow: no beat, no read, and the unit is not busy.
bool Cosimulation::drain() {
  constexpr int kLongerThanThePipeline = 40;
  for (int i = 0; i < kLongerThanThePipeline; ++i, ++cycle_) {
    wave_cycle();
    RtlUnit::Inputs inputs;
    inputs.accumulate_ready = inputs.memory_request_ready = true;
    unit_->cycle(inputs);
    const RtlUnit::Outputs outputs = unit_->outputs();
    for (std::size_t index = 0; index < kStageCount; ++index) {
      const auto stage = static_cast<Stage>(index);
      if ((outputs.taken >> index & 1) != 0) return scoreboard_.check(stage, unit_->beat(stage), cycle_);
    }
    if (outputs.memory_request_valid) return fail(Stage::kFetch, "a memory read after the last pixel");
    if (outputs.busy) return fail(Stage::kGroup, "busy_o stays high after the last pixel");
  }
  return true;
}

bool Cosimulation::run(const Batch& batch, const PixelSink& sink) {
  if (mismatch()) return false;
  begin(batch);
  const Conditions conditions = batch.conditions.value_or(timing_.conditions());
  const std::uint64_t part = derived_seed(timing_.seed, batches_);
  std::optional<MemoryModel> memory(std::in_place, *batch.memory, conditions, derived_seed(part, 1));
  StallSource request_stalls(conditions.at(Port::kRequest), derived_seed(part, 2));
  StallSource pixel_stalls(conditions.at(Port::kPixel), derived_seed(part, 3));
  SplitMix64 resets(derived_seed(part, 4));
  std::uint64_t resets_left = conditions.resets == 0 ? 0 : Conditions::kMostResets;

  std::array<std::uint32_t, beat_words<RequestBeat<kUnit>>()> request{};
  std::size_t offered = 0;
  std::uint64_t pixels = 0;
  bool offering = false;
  // Longer than any legal wait: all probes of 8 misses each, with their latency and their stalls.
  double patience = kUnit.max_probes * 8.0 * (conditions.memory_latency + 20) * 8;
  for (const StallPattern& pattern : conditions.stalls) patience *= pattern.cycles();
  patience += 2000;
  std::uint64_t last_progress = cycle_;
  std::uint64_t last_pixel = cycle_;

  while (pixels < batch.lookups.size()) {
    if (resets_left != 0 && resets.chance(conditions.resets)) {
      reset();
      --resets_left;
      memory_reads_ += memory->requests();
      memory.emplace(*batch.memory, conditions, derived_seed(part, 4 + resets_));
      // What was inside is asked for again.
      offered = pixels;
      offering = false;
      last_progress = last_pixel = cycle_;
    }
    wave_cycle();
    memory->begin_cycle(cycle_);
    if (!request_stalls.stalls() && !offering && offered < batch.lookups.size()) {
      const std::uint64_t lookup = batch.first_lookup + offered;
      const auto beat = make_request<kUnit>(batch.lookups[offered], static_cast<std::int64_t>(lookup));
      scoreboard_.expect(beat, batch.sampler, *batch.memory, lookup);
      pack(beat, request);
      unit_->set_request(request);
      offering = true;
    }
    RtlUnit::Inputs inputs;
    inputs.request_valid = offering;
    inputs.memory_request_ready = memory->request_ready();
    inputs.memory_zero_latency = memory->responds_in_same_cycle();
    inputs.memory_response_valid = memory->response_valid();
    if (memory->response_valid()) unit_->set_memory_response(memory->response());
    inputs.accumulate_ready = !pixel_stalls.stalls();
    unit_->cycle(inputs);

    const RtlUnit::Outputs outputs = unit_->outputs();
    const bool asks = outputs.memory_request_valid && inputs.memory_request_ready;
    pace_ = (pace_ ^ (outputs.taken | unsigned{asks} << kStageCount)) * 0x100000001b3;  // FNV-1a
    bool holds = true;
    for (std::size_t index = 0; index < kStageCount && holds; ++index) {
      if ((outputs.taken >> index & 1) == 0) continue;
      const auto stage = static_cast<Stage>(index);
      const auto got = unit_->beat(stage);
      holds = scoreboard_.check(stage, got, cycle_);
      last_progress = cycle_;
      if (holds && stage == Stage::kAccumulate) {
        last_pixel = cycle_;
        if (sink) sink(batch.first_lookup + pixels, unpack<AccumulateBeat<kUnit>>(got));
        ++pixels;
      }
    }
    if (!holds) scoreboard_.blame_plan(unit_->beat(Stage::kPlan), cycle_);
    holds = holds && check_protocol(outputs, inputs) && check_busy(outputs, batch.first_lookup + offered);
    if (outputs.request_ready && offering) {
      offering = false;
      ++offered;
      ++inside_;
    }
    if (outputs.accumulate_valid && inputs.accumulate_ready) --inside_;
    if (asks && !memory->take_request(outputs.memory_request_line, cycle_)) {
      holds = holds && fail(Stage::kFetch, "a read beyond the texture's last line");
    }
    if (memory->response_valid() && outputs.memory_response_ready) memory->take_response();
    ++cycle_;
    if (!holds) {
      memory_reads_ += memory->requests();
      // A few cycles more, for whoever reads the waveform of a mismatch.
      for (; wave_ && wave_->last_cycle != WaveWindow::kToTheEnd && cycle_ <= wave_->last_cycle; ++cycle_) {
        wave_cycle();
        RtlUnit::Inputs held = inputs;
        held.accumulate_ready = held.memory_request_ready = false;
        unit_->cycle(held);
      }
      return false;
    }
    if (static_cast<double>(cycle_ - last_progress) > patience || static_cast<double>(cycle_ - last_pixel) > patience) {
      memory_reads_ += memory->requests();
      if (!scoreboard_.blame_stopped(outputs.offered, batch.first_lookup + offered, last_progress)) {
        fail(Stage::kGroup, "the unit takes no request");
      }
      return false;
    }
  }
  memory_reads_ += memory->requests();
  return scoreboard_.finish(cycle_) && (batch.same_texture_follows || drain());
}

}  // namespace feline
