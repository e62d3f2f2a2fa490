// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tables/sampler_enums.h"

namespace feline::reference {

// Red, green, blue, alpha; linear light, 1 is full.
using Colour = std::array<double, 4>;

inline void add_weighted(Colour& sum, double weight, const Colour& colour) {
  for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * colour[c];
}

// float32 holds 8-bit codes / 255 to 3e-8; arithmetic on them is double.
using Texel = std::array<float, 4>;

inline void add_weighted(Colour& sum, double weight, const Texel& texel) {
  for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * static_cast<double>(texel[c]);
}

// One image of a chain, rows from the top.
struct Level {
  int width = 0;
  int height = 0;
  std::vector<Texel> texels;

  const Texel& at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

// What lies beyond a texture's edges (OpenGL 4.6, 8.14.2).
struct Wrapping {
  Wrap s = Wrap::kRepeat;
  Wrap t = Wrap::kRepeat;
  Texel border{0, 0, 0, 0};
};

// A texture with its mip levels, finest first; level k measures max(1, size >> k).
struct MipMap {
  std::vector<Level> levels;
  Wrapping wrapping;

  int last_level() const { return static_cast<int>(levels.size()) - 1; }
  const Level& base() const { return levels.front(); }
  // Where the full chain reaches 1 x 1, though this one may end before.
  int smallest_level() const {
    return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(base().width, base().height)))) - 1;
  }
};

// Images of one texture reduced in each direction on its own: at(i, j) measures max(1, width >> i) by max(1, height >>
// j) (RIP mapping; Heckbert 1986, Larson and Shah 1993).
struct RipMap {
  int columns = 0;
  int rows = 0;
  std::vector<Level> levels;
  Wrapping wrapping;

  const Level& at(int i, int j) const {
    return levels[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
  }
};

// The texel of an axis that stands for `index`, which may be anywhere; -1 is the border.
int wrap_index(std::int64_t index, int size, Wrap wrap);

// The texel at any whole coordinates.
const Texel& wrapped_texel(const Level& level, const Wrapping& wrapping, std::int64_t x, std::int64_t y);

}  // namespace feline::reference
