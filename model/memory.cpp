// SPDX-License-Identifier: Apache-2.0
#include "model/memory.h"

#include <algorithm>

namespace feline {
namespace {

bool has_no_alpha(const Texture& texture) {
  if (texture.format != TexelFormat::kRgba8) return false;
  constexpr std::size_t kTexelBytes = 4;
  for (const MipLevel& level : texture.levels) {
    for (std::size_t i = kTexelBytes - 1; i < level.texels.size(); i += kTexelBytes) {
      if (level.texels[i] != 255) return false;
    }
  }
  return true;
}

}  // namespace

TextureMemory layout_texture(const Texture& texture, std::int64_t first_line) {
  const auto texel_bytes = static_cast<std::size_t>(bytes_per_texel(texture.format));
  TextureMemory memory;
  memory.is_opaque = has_no_alpha(texture);
  memory.first_line = first_line;
  for (const MipLevel& level : texture.levels) {
    const auto first = static_cast<std::int64_t>(memory.lines());
    memory.level_base.push_back(first_line + first);
    const int tiles_a_row = (level.width + kTileSide - 1) / kTileSide;
    memory.bytes.resize(memory.bytes.size() +
                        static_cast<std::size_t>(level_lines(level.width, level.height)) * kLineBytes);
    for (int y = 0; y < level.height; ++y) {
      for (int x = 0; x < level.width; ++x) {
        const auto line = static_cast<std::size_t>(first + std::int64_t{y / kTileSide} * tiles_a_row + x / kTileSide);
        const auto slot = static_cast<std::size_t>(y % kTileSide * kTileSide + x % kTileSide);
        const auto from =
            (static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x)) *
            texel_bytes;
        std::copy_n(level.texels.begin() + static_cast<std::ptrdiff_t>(from), texel_bytes,
                    memory.bytes.begin() + static_cast<std::ptrdiff_t>(line * kLineBytes + slot * texel_bytes));
      }
    }
  }
  return memory;
}

}  // namespace feline
