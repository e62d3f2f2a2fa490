// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace feline {

// xoshiro256** started by splitmix64, and distributions of our own: the same sequence on every host.
class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (auto& word : state_) {
      seed += 0x9e3779b97f4a7c15;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
      z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
      word = z ^ (z >> 31);
    }
  }

  std::uint64_t bits() {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }
  // 0 .. count - 1; count <= 2^32, whose bias of 2^-32 does not matter here.
  std::int64_t below(std::int64_t count) {
    return static_cast<std::int64_t>(((bits() >> 32) * static_cast<std::uint64_t>(count)) >> 32);
  }
  std::int64_t between(std::int64_t low, std::int64_t high) { return low + below(high - low + 1); }
  bool one_in(std::int64_t count) { return below(count) == 0; }
  // 0 <= unit < 1, 53 bits.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double real(double low, double high) { return low + (high - low) * unit(); }
  template <typename T, std::size_t kSize>
  const T& pick(const std::array<T, kSize>& from) {
    return from[static_cast<std::size_t>(below(static_cast<std::int64_t>(kSize)))];
  }

 private:
  std::array<std::uint64_t, 4> state_{};
};

// FELINE_SEED, decimal, or 1.
inline std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* text = std::getenv("FELINE_SEED");
    return text == nullptr ? std::uint64_t{1} : std::strtoull(text, nullptr, 10);
  }();
  return value;
}

// Every test has its own sequence, whatever ran before it.
inline Random random_for(std::string_view test) {
  std::uint64_t salt = 0xcbf29ce484222325;
  for (const char c : test) salt = (salt ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return Random(seed() ^ (salt << 1));
}

// Names the seed in every failure of the scope.
class SeedTrace {
 public:
  SeedTrace(const char* file, int line) : trace_(file, line, "repeat with FELINE_SEED=" + std::to_string(seed())) {}

 private:
  ::testing::ScopedTrace trace_;
};

}  // namespace feline
