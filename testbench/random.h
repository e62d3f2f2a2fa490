// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace feline {

// splitmix64: the same sequence on every host. Steele, Lea, Flood, "Fast splittable pseudorandom number generators",
// OOPSLA 2014.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  // 0 .. count - 1; the bias of at most count/2^32 does not matter here.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32); }
  bool chance(double probability) { return static_cast<double>(next() >> 11) * 0x1p-53 < probability; }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

// A seed of its own for each part of a run.
inline std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t part) {
  return SplitMix64(seed ^ (part * 0xd1342543de82ef95 + 1)).next();
}

}  // namespace feline
