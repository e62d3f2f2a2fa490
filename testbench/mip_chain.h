// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/texture.h"

namespace feline {

// The filter that makes a level from the one before (McCormack et al. 1999, section 4).
enum class MipFilter : std::uint8_t {
  kLanczos,  // radius 3 in destination texels: for trilinear, Texram, EXT and Feline
  kBox,      // area average: for EWA
};

// What lies beyond an edge while a level is filtered.
enum class MipEdge : std::uint8_t {
  kClamp,   // the edge texel goes on: for clamped textures, and close enough for mirrored ones
  kRepeat,  // the texture is periodic: no seam at coarse levels
};

// The size of level k of a texture whose level 0 has this size: max(1, size >> k).
constexpr int mip_size(int size, int level) {
  const int shifted = level < 31 ? size >> level : 0;
  return shifted > 1 ? shifted : 1;
}

// Levels down to 1 x 1, level 0 included: floor(log2(max(width, height))) + 1.
constexpr int mip_count(int width, int height) {
  int count = 1;
  while (mip_size(width, count - 1) > 1 || mip_size(height, count - 1) > 1) ++count;
  return count;
}

// The chain of base down to 1 x 1; levels[0] is base, unchanged.
//   base      row-major, 8 bit unorm, channels interleaved; sides at least 1
//   channels  1, 2 or 4; the fourth is alpha, filtered on its own (unassociated)
//   srgb      colours are sRGB encoded: filtered in linear light, encoded again; alpha is linear
// Every level is made from the one before in float32; only the stored texels are rounded (nearest,
// half up) and clamped, so that errors do not add up and Lanczos' overshoot is not lost half way.
// A constant channel stays exactly constant at every level.
// Throws std::invalid_argument when the texels do not fill the size.
std::vector<MipLevel> build_mip_chain(MipLevel base, int channels, MipFilter filter, bool srgb,
                                      MipEdge edge = MipEdge::kClamp);

// A level in light, channels interleaved, before it is stored: values of any size and sign.
struct FloatLevel {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

// The same chain with nothing rounded to stored texels; every texel of it is a linear function of base.
std::vector<FloatLevel> build_float_mip_chain(FloatLevel base, int channels, MipFilter filter,
                                              MipEdge edge = MipEdge::kClamp);

// Images reduced in each direction on its own, for RIP mapping: image j * columns + i measures mip_size(width, i) by
// mip_size(height, j), down to one texel in both; otherwise as build_mip_chain.
struct RipChain {
  int columns = 0;
  int rows = 0;
  std::vector<MipLevel> images;
};
RipChain build_rip_chain(const MipLevel& base, int channels, MipFilter filter, bool srgb,
                         MipEdge edge = MipEdge::kClamp);

}  // namespace feline
