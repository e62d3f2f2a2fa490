// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "testbench/random.h"

namespace feline {

// Where the world around the unit can make it wait.
enum class Port : std::uint8_t { kRequest, kPixel, kMemoryRequest, kMemoryResponse };
inline constexpr std::size_t kPortCount = 4;

// In each cycle that is free a stall begins with this chance; it lasts 1 to `longest` cycles.
struct StallPattern {
  double chance = 0;  // below 1
  std::uint32_t longest = 1;
  // The mean number of cycles that a transfer takes.
  double cycles() const { return 1 + chance / (1 - chance) * (1 + longest) / 2; }
};

// What goes on around the unit.
struct Conditions {
  int memory_latency = 20;  // cycles, >= 0; with stalls of the response, each read takes up to twice as long
  std::array<StallPattern, kPortCount> stalls{};
  double resets = 0;  // chance of a reset in each cycle, until a batch has had kMostResets: it must come to its end
  static constexpr std::uint64_t kMostResets = 8;

  StallPattern& at(Port port) { return stalls[static_cast<std::size_t>(port)]; }
  const StallPattern& at(Port port) const { return stalls[static_cast<std::size_t>(port)]; }
};

// Conditions of every kind, from none to long stalls at any of the ports, latencies from 0 to 1000 cycles, each octave
// as likely as another, and resets.
Conditions random_conditions(SplitMix64& random);

// The stalls of one port.
class StallSource {
 public:
  StallSource(const StallPattern& pattern, std::uint64_t seed) : pattern_(pattern), random_(seed) {}

  // Once a cycle.
  bool stalls() {
    if (pattern_.chance == 0) return false;
    if (left_ == 0 && random_.chance(pattern_.chance)) left_ = 1 + random_.below(pattern_.longest);
    return left_ != 0 && left_-- != 0;
  }

 private:
  StallPattern pattern_;
  SplitMix64 random_;
  std::uint32_t left_ = 0;
};

}  // namespace feline
