// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <span>

#include "model/memory.h"
#include "testbench/random.h"

namespace feline {

// A read port's other end: answers in order, each `latency` cycles after its request; with stalls a random number of
// cycles from that to twice as many, and later still with the chance of a stall in every cycle. latency >= 1.
class MemoryModel {
 public:
  MemoryModel(const TextureMemory& memory, int latency, double stall, std::uint64_t seed)
      : memory_(memory), latency_(latency), stall_(stall), random_(seed) {}

  // Called once a cycle, before the unit's; then both answers hold for that cycle.
  void begin_cycle(std::uint64_t cycle);
  bool request_ready() const { return request_ready_; }
  bool response_valid() const { return response_valid_; }
  std::span<const std::uint8_t> response() const { return memory_.line(waiting_.front().line); }

  // False when there is no such line.
  [[nodiscard]] bool take_request(std::uint32_t line, std::uint64_t cycle);
  void take_response();
  std::uint64_t requests() const { return requests_; }

 private:
  struct Waiting {
    std::int64_t line;
    std::uint64_t due;
  };
  const TextureMemory& memory_;
  int latency_;
  double stall_;
  SplitMix64 random_;
  std::deque<Waiting> waiting_;
  bool request_ready_ = false;
  bool response_valid_ = false;
  std::uint64_t requests_ = 0;
};

}  // namespace feline
