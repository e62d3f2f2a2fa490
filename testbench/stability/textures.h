// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "model/memory.h"
#include "model/sampler.h"

namespace feline::stability {

// How steep a mip level is, and how far from the next one, in codes: bounds of colours rest on it.
struct LevelSlope {
  double s = 0;        // largest difference of neighbouring texels times the width: codes a texture, along s
  double t = 0;        // the same along t
  double to_next = 0;  // largest difference to the next coarser level, both interpolated; 0 for the last
  double range = 0;    // highest less lowest texel
};

// A smooth picture of one channel, repeated without a seam: three waves of 1 to 3 periods, each level box-filtered.
class TestTexture {
 public:
  TestTexture(int width, int height);

  const Texture& texture() const { return texture_; }
  const TextureMemory& memory() const { return memory_; }
  const SamplerState<kDefaultConfig>& simple() const { return simple_; }
  const SamplerState<kDefaultConfig>& table() const { return table_; }
  int width() const { return texture_.levels.front().width; }
  int height() const { return texture_.levels.front().height; }
  int last_level() const { return static_cast<int>(texture_.levels.size()) - 1; }
  // Of the levels from `finest` on: each field's largest.
  const LevelSlope& slope_from(int finest) const;
  // Whether texels and textures differ by powers of two, so that a float32 gradient is exact in texels.
  bool exact_in_texels() const;

 private:
  Texture texture_;
  TextureMemory memory_;
  SamplerState<kDefaultConfig> simple_;
  SamplerState<kDefaultConfig> table_;
  std::vector<LevelSlope> slopes_;
};

// The first is the one that classes use which are not about size.
const std::vector<std::unique_ptr<TestTexture>>& test_textures();

}  // namespace feline::stability
