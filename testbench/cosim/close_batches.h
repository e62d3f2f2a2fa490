// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "testbench/cosim/cosimulation.h"

namespace feline {

// Lookups whose textures are chosen so that the exact sum of every channel all but rounds the other way in accumulate,
// or is a tie: the least significant bit of every product and carry decides. Random lookups that blend two levels;
// random texels, of which four, found by meeting in the middle, bring the sum where it is wanted; half of them at a
// border, whose alpha has fractions of codes; a quarter with a coordinate that raises a status bit. Each several times,
// so that one may wait for another; pixels of half of them are left standing for long.
class CloseBatches {
 public:
  static constexpr std::size_t kCopies = 4;

  // Of two processors less than a minute a thousand.
  CloseBatches(std::uint64_t seed, std::uint64_t lookups);

  std::size_t size() const { return batches_.size(); }
  // kCopies of one lookup.
  Batch operator[](std::size_t i) const;
  // Of a channel, the steps of its exact sum from where it begins to round to the next code.
  std::int64_t distance(std::size_t i, std::size_t channel) const;

 private:
  struct Close {
    SamplerState<kUnit> sampler;
    TextureMemory memory;
    std::array<Lookup, kCopies> lookups;
  };
  static Close choose(std::uint64_t seed, std::uint64_t number);

  std::vector<Close> batches_;
};

}  // namespace feline
