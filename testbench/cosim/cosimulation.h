// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "model/lookup.h"
#include "model/sampler.h"
#include "testbench/cosim/conditions.h"
#include "testbench/cosim/rtl_unit.h"
#include "testbench/cosim/scoreboard.h"

namespace feline {

// Lookups under one sampler state and texture.
struct Batch {
  SamplerState<kUnit> sampler;
  const TextureMemory* memory = nullptr;
  std::span<const Lookup> lookups;
  std::uint64_t first_lookup = 0;  // the number of lookups.front() in the run, for messages and tags
  // The next batch has the same texture: it begins at once, and the unit is neither flushed nor reset before.
  bool same_texture_follows = false;
  std::optional<Conditions> conditions{};  // instead of those of the run
  bool begins_with_reset = false;          // the lines of the texture before it are forgotten by one, not by a flush
};

struct Timing {
  int memory_latency = 20;  // cycles, >= 0; with stalls, each read takes up to twice as long
  double stalls = 0;        // chance of a stall, 0 .. 0.95, at each port and cycle
  std::uint64_t seed = 1;
  Conditions conditions() const;
};

// A window of cycles that is written to a waveform, a mismatch's to its last cycle; kToTheEnd: as long as lookups are
// compared.
struct WaveWindow {
  static constexpr std::uint64_t kToTheEnd = std::numeric_limits<std::uint64_t>::max() - 1;
  std::filesystem::path path;
  std::uint64_t first_cycle = 0;
  std::uint64_t last_cycle = 0;
};

using PixelSink = std::function<void(std::uint64_t lookup, const AccumulateBeat<kUnit>& pixel)>;

// Drives one unit, compares every beat of every stage with the model, stops at the first difference.
class Cosimulation {
 public:
  // Throws std::runtime_error when the unit's fingerprint is not the model's: a stale build.
  Cosimulation(const RtlFactory& factory, const Timing& timing);

  void set_wave(WaveWindow window) { wave_ = std::move(window); }
  // False at the first mismatch. May be called again for the next batch.
  bool run(const Batch& batch, const PixelSink& sink = {});

  const std::optional<Mismatch>& mismatch() const {
    return scoreboard_.mismatch() ? scoreboard_.mismatch() : protocol_;
  }
  const std::array<std::uint64_t, kStageCount>& beats() const { return scoreboard_.beats(); }
  std::uint64_t cycles() const { return cycle_; }
  std::uint64_t memory_reads() const { return memory_reads_; }
  std::uint64_t resets() const { return resets_; }
  // A hash of which stages gave a beat, and whether the memory was asked, in which cycle.
  std::uint64_t pace() const { return pace_; }

 private:
  void begin(const Batch& batch);
  void reset();
  bool drain();
  bool check_protocol(const RtlUnit::Outputs& outputs, const RtlUnit::Inputs& inputs);
  bool check_busy(const RtlUnit::Outputs& outputs, std::uint64_t entered);
  bool fail(Stage stage, std::string note);
  void wave_cycle();

  Timing timing_;
  std::unique_ptr<RtlUnit> unit_;
  Scoreboard scoreboard_;
  std::optional<Mismatch> protocol_;
  std::optional<WaveWindow> wave_;
  std::uint64_t cycle_ = 0;
  std::uint64_t memory_reads_ = 0;
  std::uint64_t resets_ = 0;
  std::uint64_t pace_ = 0;
  std::uint64_t batches_ = 0;
  bool same_texture_ = false;
  std::uint64_t inside_ = 0;  // requests taken less pixels taken
  RtlUnit::Outputs held_;     // offered, not yet taken
  std::array<std::vector<std::uint32_t>, kStageCount> held_beats_;
};

}  // namespace feline
