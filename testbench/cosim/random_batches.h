// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/cosim/cosimulation.h"
#include "testbench/cosim/float_patterns.h"
#include "testbench/cosim/sampler_choices.h"
#include "testbench/random.h"

namespace feline {

// A legal sampler.
SamplerOptions random_sampler(SplitMix64& random, const SamplerChoices& choices);
// Random texels on so many levels, or as many as there are.
Texture random_texture(SplitMix64& random, TexelFormat format, bool srgb, int width, int height, int levels);
// Tame footprints, every float32 class in every operand, arbitrary bits, and derivatives that nearly round otherwise.
Lookup random_lookup(SplitMix64& random, int width, int height);

// A batch of random and directed lookups under a random legal sampler and a random small texture, all of it a function
// of seed and number alone. Lookups are those of random_lookup; an eighth of them have one operand of float_patterns.h,
// whose every value each operand has within kPatternPeriod lookups. Two batches after one another share a texture: the
// second begins at once, under another sampler. Textures: every format, sRGB, powers of two and not, 1 x 1, 1 x N,
// N x 1, strips up to 16384 long; full and cut mip chains; anywhere in the unit's memory, some of them where the one
// before lay; some batches begin with a reset.
class RandomBatches {
 public:
  static constexpr std::uint64_t kPatternPeriod = std::uint64_t{8} * 6 * kFloatPatterns;

  RandomBatches(std::uint64_t seed, std::uint64_t batch_lookups);
  void set_choices(SamplerChoices choices) { choices_ = std::move(choices); }
  // Gives every batch conditions of its own.
  void vary_conditions() { vary_ = true; }
  // Every texture begins at line 0 of the memory.
  void keep_at_line_0() { anywhere_ = false; }
  // Valid until the next call. The last batch of `lookups` may be shorter.
  Batch make(std::uint64_t number, std::uint64_t lookups);
  const SamplerOptions& options() const { return options_; }

 private:
  std::uint64_t seed_;
  std::uint64_t batch_lookups_;
  SamplerChoices choices_;
  bool vary_ = false;
  bool anywhere_ = true;
  std::optional<std::uint64_t> loaded_;  // the pair of batches whose texture it is
  SamplerOptions options_;
  Texture texture_;
  TextureMemory memory_;
  std::vector<Lookup> lookups_;
};

}  // namespace feline
