// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/cosim/random_batches.h"

namespace feline::coverage {

// Lookups into textures whose levels lie anywhere in a memory as large as the largest texture needs, 1.4 GB by the
// default configuration: addresses with every bit. Texels are random. Now and then the sampler state says that the
// texture has more levels, or the application granted more probes, than the machine has.
class VastBatches {
 public:
  enum class Choice : std::uint8_t {
    kAny,     // textures of any size, samplers and lookups of any kind
    kBorder,  // small textures under clamp to border, probes around their edges
    kThin,    // one texel, or a power of two and one, against the largest side: the longest steps that there are
  };

  explicit VastBatches(std::uint64_t seed);
  // Valid until the next call.
  Batch make(Choice choice, std::size_t lookups);

 private:
  SplitMix64 random_;
  TextureMemory memory_;
  std::vector<Lookup> lookups_;
};

}  // namespace feline::coverage
