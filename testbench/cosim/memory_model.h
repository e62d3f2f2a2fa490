// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <span>

#include "model/memory.h"
#include "testbench/cosim/conditions.h"

namespace feline {

// A read port's other end: answers in order, each as many cycles after its request as the conditions' latency says, 0
// being the request's own; with stalls of the response a random number of cycles from that to twice as many, and later
// still while it stalls.
class MemoryModel {
 public:
  MemoryModel(const TextureMemory& memory, const Conditions& conditions, std::uint64_t seed);

  // Called once a cycle, before the unit's; what the next three say then holds for that cycle.
  void begin_cycle(std::uint64_t cycle);
  bool request_ready() const { return request_ready_; }
  bool responds_in_same_cycle() const { return responds_in_same_cycle_; }
  bool response_valid() const { return response_valid_; }
  std::span<const std::uint8_t> response() const { return memory_.line(waiting_.front().line); }

  // A response in the same cycle is valid from then on. False when there is no such line.
  [[nodiscard]] bool take_request(std::uint32_t line, std::uint64_t cycle);
  void take_response();
  std::uint64_t requests() const { return requests_; }

 private:
  struct Waiting {
    std::int64_t line;
    std::uint64_t due;
  };
  const TextureMemory& memory_;
  std::uint32_t latency_;
  bool jitter_;
  StallSource request_stalls_;
  StallSource response_stalls_;
  SplitMix64 random_;
  std::deque<Waiting> waiting_;
  bool request_ready_ = false;
  bool responds_in_same_cycle_ = false;
  bool response_valid_ = false;
  std::uint64_t requests_ = 0;
};

}  // namespace feline
