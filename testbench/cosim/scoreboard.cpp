// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/scoreboard.h"

#include <algorithm>

namespace feline {

std::span<std::uint32_t> BeatQueue::push(std::uint64_t lookup, std::uint64_t probe) {
  names_.push_back({lookup, probe});
  data_.resize(names_.size() * words_);
  return std::span(data_).last(words_);
}

BeatQueue::Entry BeatQueue::front() const {
  return {names_[first_][0], names_[first_][1], std::span(data_).subspan(first_ * words_, words_)};
}

void BeatQueue::pop() {
  ++first_;
  // Given up in blocks, so that popping stays cheap and memory bounded.
  constexpr std::size_t kBlock = 1024;
  if (first_ == names_.size()) {
    clear();
  } else if (first_ == kBlock) {
    names_.erase(names_.begin(), names_.begin() + kBlock);
    data_.erase(data_.begin(), data_.begin() + static_cast<std::ptrdiff_t>(kBlock * words_));
    first_ = 0;
  }
}

void BeatQueue::clear() {
  names_.clear();
  data_.clear();
  first_ = 0;
}

Scoreboard::Scoreboard() {
  [&]<std::size_t... kStage>(std::index_sequence<kStage...>) {
    (queues_.emplace_back(static_cast<std::size_t>(beat_words<StageBeat<kUnit, kStage>>())), ...);
  }
  (std::make_index_sequence<kStageCount>{});
}

void Scoreboard::forget() {
  for (BeatQueue& queue : queues_) queue.clear();
}

void Scoreboard::expect(const RequestBeat<kUnit>& request, const SamplerState<kUnit>& sampler,
                        const TextureMemory& memory, std::uint64_t lookup) {
  std::array<std::uint64_t, kStageCount> count{};
  sample<kUnit>(request, sampler, memory, [&]<typename Beat>(const Beat& beat) {
    constexpr std::size_t kStage = stage_of<kUnit, Beat>();
    if constexpr (kStage < kStageCount) pack(beat, queues_[kStage].push(lookup, count[kStage]++));
  });
}

bool Scoreboard::check(Stage stage, std::span<const std::uint32_t> got, std::uint64_t cycle) {
  const auto index = static_cast<std::size_t>(stage);
  BeatQueue& queue = queues_[index];
  Mismatch found{Mismatch::Kind::kUnexpected, stage, nearest_lookup(stage), 0, cycle, {}, {got.begin(), got.end()}, ""};
  if (!queue.empty()) {
    const BeatQueue::Entry expected = queue.front();
    if (std::ranges::equal(expected.words, got)) {
      last_lookup_[index] = expected.lookup;
      queue.pop();
      ++beats_[index];
      return true;
    }
    found.kind = Mismatch::Kind::kValue;
    found.lookup = expected.lookup;
    found.probe = expected.probe;
    found.expected.assign(expected.words.begin(), expected.words.end());
  }
  if (!mismatch_) mismatch_ = found;
  return false;
}

void Scoreboard::blame_plan(std::span<const std::uint32_t> offered, std::uint64_t cycle) {
  const BeatQueue& plans = queues_[static_cast<std::size_t>(Stage::kPlan)];
  if (!mismatch_ || mismatch_->stage != Stage::kWalk || plans.empty()) return;
  const BeatQueue::Entry plan = plans.front();
  if (plan.lookup != mismatch_->lookup || std::ranges::equal(plan.words, offered)) return;
  mismatch_ = Mismatch{Mismatch::Kind::kValue,
                       Stage::kPlan,
                       plan.lookup,
                       plan.probe,
                       cycle,
                       {plan.words.begin(), plan.words.end()},
                       {offered.begin(), offered.end()},
                       ""};
}

// Records the stage's first owed beat, if there is one, as missing.
bool Scoreboard::owed(std::size_t stage, std::uint64_t cycle) {
  if (queues_[stage].empty()) return false;
  const BeatQueue::Entry expected = queues_[stage].front();
  mismatch_ = Mismatch{Mismatch::Kind::kMissing,
                       static_cast<Stage>(stage),
                       expected.lookup,
                       expected.probe,
                       cycle,
                       {expected.words.begin(), expected.words.end()},
                       {},
                       ""};
  return true;
}

bool Scoreboard::finish(std::uint64_t cycle) {
  for (std::size_t stage = 0; stage < kStageCount && !mismatch_; ++stage) owed(stage, cycle);
  return !mismatch_;
}

bool Scoreboard::blame_stopped(std::uint32_t offered, std::uint64_t entered, std::uint64_t cycle) {
  const auto offers = [&](std::size_t stage) { return (offered >> stage & 1) != 0; };
  for (std::size_t stage = kStageCount; stage-- > 0;) {
    if (queues_[stage].empty() || offers(stage)) continue;
    const BeatQueue::Entry owes = queues_[stage].front();
    bool has_input = owes.lookup < entered;
    if (stage > 0 && !queues_[stage - 1].empty()) {
      const BeatQueue::Entry next = queues_[stage - 1].front();
      // accumulate needs all probes of its lookup: the last one is delivered when filter owes the next lookup.
      const bool per_probe = static_cast<Stage>(stage) > Stage::kWalk && static_cast<Stage>(stage) < Stage::kAccumulate;
      has_input = offers(stage - 1) || next.lookup > owes.lookup ||
                  (per_probe && next.lookup == owes.lookup && next.probe > owes.probe);
    }
    if (has_input) return owed(stage, cycle);
  }
  return false;
}

std::uint64_t Scoreboard::nearest_lookup(Stage stage) const {
  const auto index = static_cast<std::size_t>(stage);
  return queues_[index].empty() ? last_lookup_[index] : queues_[index].front().lookup;
}

}  // namespace feline
