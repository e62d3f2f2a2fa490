// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "tables/pack.h"
#include "tables/unit.h"
#include "testbench/cosim/rtl_unit.h"

namespace feline {

// A port of any width as words: Verilator gives 8, 16, 32 and 64 bit integers and arrays of 32 bit words.
template <typename Port>
void store_port(Port& port, std::span<const std::uint32_t> words) {
  if constexpr (std::is_integral_v<Port>) {
    std::uint64_t value = 0;
    for (std::size_t i = words.size(); i-- > 0;) value = (value << 32) | words[i];
    port = static_cast<Port>(value);
  } else {
    for (std::size_t i = 0; i < words.size(); ++i) port[i] = words[i];
  }
}

template <typename Port>
void load_port(const Port& port, std::span<std::uint32_t> words) {
  if constexpr (std::is_integral_v<Port>) {
    const std::uint64_t value = port;
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint32_t>(value >> (32 * i));
  } else {
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = port[i];
  }
}

// RtlUnit over a class that Verilator made from feline_bench; Wave is a trace writer or void.
template <typename Verilated, typename Wave = void>
class VerilatedUnit : public RtlUnit {
 public:
  explicit VerilatedUnit(std::uint64_t seed) {
    context_.randReset(2);
    context_.randSeed(static_cast<int>(seed & 0x7fffffff));
    context_.traceEverOn(!std::is_void_v<Wave>);
    unit_ = std::make_unique<Verilated>(&context_);
    unit_->clk_i = 0;
    unit_->rst_i = 1;
    unit_->eval();
  }
  ~VerilatedUnit() override {
    close_wave();
    unit_->final();
  }

  std::uint64_t fingerprint() override { return unit_->fingerprint_o; }
  void set_sampler(std::span<const std::uint32_t> words) override { store_port(unit_->sampler_i, words); }
  void set_request(std::span<const std::uint32_t> words) override { store_port(unit_->request_i, words); }
  void set_memory_response(std::span<const std::uint8_t> line) override {
    for (std::size_t i = 0; i < line.size() / 4; ++i) {
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < 4; ++k) word |= std::uint32_t{line[4 * i + k]} << (8 * k);
      unit_->memory_response_data_i[i] = word;
    }
  }

  void cycle(const Inputs& inputs) override {
    unit_->rst_i = inputs.reset;
    unit_->flush_i = inputs.flush;
    unit_->request_valid_i = inputs.request_valid;
    unit_->memory_request_ready_i = inputs.memory_request_ready;
    unit_->memory_zero_latency_i = inputs.memory_zero_latency;
    unit_->memory_response_valid_i = inputs.memory_response_valid;
    unit_->accumulate_ready_i = inputs.accumulate_ready;
    // The wrapper takes these inputs at the edge that ends the cycle before (feline_bench.sv).
    unit_->clk_i = 0;
    unit_->eval();
    dump();
    unit_->clk_i = 1;
    unit_->eval();
    dump();
  }

  Outputs outputs() const override {
    return {unit_->busy_o != 0,
            unit_->request_ready_o != 0,
            unit_->memory_request_valid_o != 0,
            unit_->memory_response_ready_o != 0,
            unit_->accumulate_valid_o != 0,
            unit_->memory_request_line_o,
            unit_->offered_o,
            unit_->taken_o};
  }

  std::span<const std::uint32_t> beat(Stage stage) const override {
    switch (stage) {
      case Stage::kGroup: return load<GroupBeat<kUnit>>(unit_->group_o);
      case Stage::kFootprint: return load<FootprintBeat<kUnit>>(unit_->footprint_o);
      case Stage::kPlan: return load<PlanBeat<kUnit>>(unit_->plan_o);
      case Stage::kWalk: return load<WalkBeat<kUnit>>(unit_->walk_o);
      case Stage::kAddress: return load<AddressBeat<kUnit>>(unit_->address_o);
      case Stage::kFetch: return load<FetchBeat<kUnit>>(unit_->fetch_o);
      case Stage::kFilter: return load<FilterBeat<kUnit>>(unit_->filter_o);
      case Stage::kAccumulate: return load<AccumulateBeat<kUnit>>(unit_->accumulate_o);
    }
    return {};
  }

  void open_wave(const std::filesystem::path& path) override {
    if constexpr (std::is_void_v<Wave>) {
      throw std::logic_error("this unit has no waveform: " + path.string());
    } else {
      constexpr int kAllLevels = 99;
      wave_ = std::make_unique<Wave>();
      unit_->trace(wave_.get(), kAllLevels);
      wave_->open(path.c_str());
    }
  }

  void close_wave() override {
    if constexpr (!std::is_void_v<Wave>) {
      if (wave_) wave_->close();
      wave_.reset();
    }
  }

 protected:
  VerilatedContext& context() { return context_; }

 private:
  struct None {};

  template <typename Beat, typename Port>
  std::span<const std::uint32_t> load(const Port& port) const {
    static_assert(beat_words<Beat>() <= kMostWords);
    const std::span<std::uint32_t> words(words_.data(), static_cast<std::size_t>(beat_words<Beat>()));
    load_port(port, words);
    return words;
  }

  void dump() {
    // Half a cycle is 5 ns: a wave reads as 100 MHz.
    context_.timeInc(5);
    if constexpr (!std::is_void_v<Wave>) {
      if (wave_) wave_->dump(context_.time());
    }
  }

  VerilatedContext context_;
  std::unique_ptr<Verilated> unit_;
  std::unique_ptr<std::conditional_t<std::is_void_v<Wave>, None, Wave>> wave_;
  static constexpr int kMostWords = 32;
  mutable std::array<std::uint32_t, kMostWords> words_{};
};

}  // namespace feline
