// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/cosim/cosimulation.h"
#include "testbench/cosim/sampler_choices.h"

namespace feline {

// A batch of random and directed lookups under a random legal sampler and a random small texture, all of it a function
// of seed and number alone. Lookups: tame footprints, every float32 class in every operand, and arbitrary bits.
// Textures: every format, sRGB, powers of two and not, 1 x 1, 1 x N, N x 1, up to 16384 wide; full and cut mip chains.
class RandomBatches {
 public:
  RandomBatches(std::uint64_t seed, std::uint64_t batch_lookups) : seed_(seed), batch_lookups_(batch_lookups) {}
  void set_choices(SamplerChoices choices) { choices_ = std::move(choices); }
  // Valid until the next call. The last batch of `lookups` may be shorter.
  Batch make(std::uint64_t number, std::uint64_t lookups);
  const SamplerOptions& options() const { return options_; }

 private:
  std::uint64_t seed_;
  std::uint64_t batch_lookups_;
  SamplerChoices choices_;
  SamplerOptions options_;
  Texture texture_;
  TextureMemory memory_;
  std::vector<Lookup> lookups_;
};

}  // namespace feline
