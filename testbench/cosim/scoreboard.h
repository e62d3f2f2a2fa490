// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/unit.h"
#include "tables/pack.h"
#include "tables/stages.h"
#include "tables/unit.h"

namespace feline {

// Where RTL and model part: the first wrong stage, and both beats as packed words.
struct Mismatch {
  enum class Kind : std::uint8_t { kValue, kUnexpected, kMissing, kProtocol };
  Kind kind = Kind::kValue;
  Stage stage = Stage::kGroup;
  std::uint64_t lookup = 0;
  std::uint64_t probe = 0;
  std::uint64_t cycle = 0;
  std::vector<std::uint32_t> expected;
  std::vector<std::uint32_t> got;
  std::string note;
};

// First in, first out, of beats of one width, with the lookup and probe each belongs to.
class BeatQueue {
 public:
  struct Entry {
    std::uint64_t lookup;
    std::uint64_t probe;
    std::span<const std::uint32_t> words;
  };

  explicit BeatQueue(std::size_t words) : words_(words) {}
  bool empty() const { return first_ == names_.size(); }
  std::span<std::uint32_t> push(std::uint64_t lookup, std::uint64_t probe);
  Entry front() const;
  void pop();
  void clear();

 private:
  std::size_t words_;
  std::size_t first_ = 0;
  std::vector<std::array<std::uint64_t, 2>> names_;
  std::vector<std::uint32_t> data_;
};

// Holds what the model says must leave each stage, in order, and compares it with what does. It knows stage
// boundaries only, never the unit's inside.
class Scoreboard {
 public:
  Scoreboard();

  // Runs the model on a lookup; its beats are expected from now on.
  void expect(const RequestBeat<kUnit>& request, const SamplerState<kUnit>& sampler, const TextureMemory& memory,
              std::uint64_t lookup);
  // A beat leaves a stage. False at the first difference, which mismatch() then tells.
  bool check(Stage stage, std::span<const std::uint32_t> got, std::uint64_t cycle);
  // walk gives its first beats while the plan is still offered. If walk was found wrong, and the plan on offer for the
  // same lookup is wrong as well, the plan is the first wrong stage.
  void blame_plan(std::span<const std::uint32_t> offered, std::uint64_t cycle);
  // The unit was reset: nothing is owed.
  void forget();
  // At the end nothing may be owed.
  bool finish(std::uint64_t cycle);
  // The unit has stopped: names the stage that holds everything up, which is the last one that owes a beat and does not
  // offer it, though what the beat is made of was delivered to it, or is offered to it. Bit k of `offered`: stage k's
  // beat is valid; lookups below `entered` were taken. False if there is none: then the unit takes no request.
  bool blame_stopped(std::uint32_t offered, std::uint64_t entered, std::uint64_t cycle);
  // The lookup whose beat a stage gave last, or would give next: where a beat out of turn belongs.
  std::uint64_t nearest_lookup(Stage stage) const;

  const std::optional<Mismatch>& mismatch() const { return mismatch_; }
  const std::array<std::uint64_t, kStageCount>& beats() const { return beats_; }

 private:
  bool owed(std::size_t stage, std::uint64_t cycle);

  std::vector<BeatQueue> queues_;
  std::array<std::uint64_t, kStageCount> beats_{};
  std::array<std::uint64_t, kStageCount> last_lookup_{};
  std::optional<Mismatch> mismatch_;
};

}  // namespace feline
