// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/texture.h"
#include "tables/formats.h"

namespace feline {

// A texture as the unit's memory holds it: lines of 64 bytes, each a 4 x 4 tile of texels, row by row, 1, 2 or 4 bytes
// a texel from byte 0 on; levels follow each other. Texels of a tile beyond the level's edge are 0 and never read.
inline constexpr int kTileSide = 1 << kTileLog2;
inline constexpr int kLineBytes = 4 * kTileSide * kTileSide;

// The lines of a level of this size, in texels.
constexpr std::int64_t level_lines(int width, int height) {
  return std::int64_t{(width + kTileSide - 1) / kTileSide} * ((height + kTileSide - 1) / kTileSide);
}

struct TextureMemory {
  std::vector<std::uint8_t> bytes;
  std::vector<std::int64_t> level_base;  // first line of each level
  std::int64_t first_line = 0;           // where the bytes are in the memory
  bool is_opaque = false;                // RGBA8, and every alpha is 255

  bool opaque() const { return is_opaque; }
  std::size_t lines() const { return bytes.size() / kLineBytes; }
  bool has_line(std::int64_t index) const {
    return index >= first_line && index - first_line < static_cast<std::int64_t>(lines());
  }
  std::span<const std::uint8_t> line(std::int64_t index) const {
    return std::span(bytes).subspan(static_cast<std::size_t>(index - first_line) * kLineBytes, kLineBytes);
  }
};

// Its first level begins at `first_line`.
TextureMemory layout_texture(const Texture& texture, std::int64_t first_line = 0);

}  // namespace feline
