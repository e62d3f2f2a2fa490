// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

#include "tables/sampler_state.h"
#include "tables/stages.h"

namespace feline {

// The texture unit's pins, whatever simulates them. A cycle is: set inputs, cycle(), look at outputs, which are those
// of the cycle in which the unit has these inputs. Beats and states are packed words (tables/pack.h).
class RtlUnit {
 public:
  struct Inputs {
    bool reset = false;
    bool flush = false;
    bool request_valid = false;
    bool memory_request_ready = false;
    bool memory_zero_latency = false;  // a request of this cycle has its response in it
    bool memory_response_valid = false;
    bool accumulate_ready = false;
  };
  struct Outputs {
    bool busy = false;
    bool request_ready = false;
    bool memory_request_valid = false;
    bool memory_response_ready = false;
    bool accumulate_valid = false;
    std::uint32_t memory_request_line = 0;
    std::uint32_t offered = 0;  // bit k: stage k's beat is valid
    std::uint32_t taken = 0;    // bit k: it is transferred in this cycle
  };

  virtual ~RtlUnit() = default;
  virtual std::uint64_t fingerprint() = 0;
  virtual void set_sampler(std::span<const std::uint32_t> words) = 0;
  virtual void set_request(std::span<const std::uint32_t> words) = 0;
  virtual void set_memory_response(std::span<const std::uint8_t> line) = 0;
  virtual void cycle(const Inputs& inputs) = 0;
  virtual Outputs outputs() const = 0;
  virtual std::span<const std::uint32_t> beat(Stage stage) const = 0;
  // Starts and ends a waveform (FST); only a unit made with waves has one.
  virtual void open_wave(const std::filesystem::path& path) = 0;
  virtual void close_wave() = 0;
};

// Makes a unit whose registers and X values start from `seed`.
using RtlFactory = std::function<std::unique_ptr<RtlUnit>(std::uint64_t seed)>;

std::unique_ptr<RtlUnit> make_fast_unit(std::uint64_t seed);
std::unique_ptr<RtlUnit> make_trace_unit(std::uint64_t seed);

}  // namespace feline
