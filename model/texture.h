// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tables/sampler_enums.h"

namespace feline {

// One level of a mip chain: rows from the top, channels interleaved, one byte each.
struct MipLevel {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> texels;
};

// Level k measures max(1, width >> k) by max(1, height >> k); the chain may end before 1 x 1.
struct Texture {
  TexelFormat format = TexelFormat::kRgba8;
  bool srgb = false;
  std::vector<MipLevel> levels;
};

}  // namespace feline
