// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "testbench/cosim/rtl_unit.h"
#include "testbench/coverage/bin_grid.h"

namespace feline::coverage {

// The functional bins of handshakes. Of every beat at every boundary and port: how many cycles nothing was offered
// before it, and how many it waited to be taken. Of every reset: which boundaries had a beat on offer.
class StallBins {
 public:
  StallBins();
  // One cycle of a unit: its inputs, and the outputs of the same cycle.
  void cycle(const RtlUnit::Inputs& inputs, const RtlUnit::Outputs& outputs);

  const std::vector<BinGrid>& grids() const { return grids_; }

 private:
  struct Wire {
    std::uint64_t gap = 0;
    std::uint64_t wait = 0;
    bool runs = false;  // a beat has been taken: from then on gaps are told
  };
  void beat(std::size_t wire, bool valid, bool ready);

  static constexpr std::size_t kWires = kStageCount + 3;
  std::array<Wire, kWires> wires_{};
  std::uint32_t offered_ = 0;  // in the cycle before
  bool memory_request_ = false;
  std::vector<BinGrid> grids_;
};

// A unit whose cycles are counted. Both live as long as the unit that is made of it.
class WatchedUnit : public RtlUnit {
 public:
  WatchedUnit(RtlUnit& unit, StallBins& bins) : unit_(unit), bins_(bins) {}
  std::uint64_t fingerprint() override { return unit_.fingerprint(); }
  void set_sampler(std::span<const std::uint32_t> words) override { unit_.set_sampler(words); }
  void set_request(std::span<const std::uint32_t> words) override { unit_.set_request(words); }
  void set_memory_response(std::span<const std::uint8_t> line) override { unit_.set_memory_response(line); }
  void cycle(const Inputs& inputs) override {
    unit_.cycle(inputs);
    bins_.cycle(inputs, unit_.outputs());
  }
  Outputs outputs() const override { return unit_.outputs(); }
  std::span<const std::uint32_t> beat(Stage stage) const override { return unit_.beat(stage); }
  void open_wave(const std::filesystem::path& path) override { unit_.open_wave(path); }
  void close_wave() override { unit_.close_wave(); }

 private:
  RtlUnit& unit_;
  StallBins& bins_;
};

}  // namespace feline::coverage
