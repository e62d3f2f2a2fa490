// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "testbench/mip_chain.h"

namespace feline {

struct TiledFile {
  int width = 0, height = 0, channels = 1, tile = 64;  // tile: its side, in texels
  int levels = 16;                                     // at most; the chain ends at 1 x 1
  OIIO::TypeDesc type = OIIO::TypeDesc::UINT8;
  std::string compression = "lzw";
};

// Channel 0 of a texel; channel c is 40 c more. Long runs, so that a large file is small and quick.
inline std::uint8_t tiled_texel(int level, int x, int y) {
  return static_cast<std::uint8_t>(x / 32 * 31 + y / 8 * 17 + level * 50);
}

// Writes a file with tiles and MIP levels, tile by tile.
inline void write_tiled(const std::filesystem::path& path, const TiledFile& file) {
  OIIO::ImageSpec spec(file.width, file.height, file.channels, file.type);
  spec.tile_width = spec.tile_height = file.tile;
  spec.attribute("compression", file.compression);
  spec.attribute("textureformat", "Plain Texture");
  spec.attribute("openexr:levelmode", file.levels > 1 ? 1 : 0);
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output) << OIIO::geterror();
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(file.tile * file.tile * file.channels));
  const int levels = std::min(file.levels, mip_count(file.width, file.height));
  for (int level = 0; level < levels; ++level) {
    spec.width = spec.full_width = mip_size(file.width, level);
    spec.height = spec.full_height = mip_size(file.height, level);
    // A TIFF's levels are written as its subimages.
    const auto append =
        output->supports("mipmap") ? OIIO::ImageOutput::AppendMIPLevel : OIIO::ImageOutput::AppendSubimage;
    const auto mode = level == 0 ? OIIO::ImageOutput::Create : append;
    ASSERT_TRUE(output->open(path.string(), spec, mode)) << output->geterror();
    for (int y = 0; y < spec.height; y += file.tile) {
      for (int x = 0; x < spec.width; x += file.tile) {
        auto texel = texels.begin();
        for (int row = y; row < y + file.tile; ++row) {
          for (int column = x; column < x + file.tile; ++column) {
            const std::uint8_t first = tiled_texel(level, column, row);
            for (int c = 0; c < file.channels; ++c) *texel++ = static_cast<std::uint8_t>(first + 40 * c);
          }
        }
        ASSERT_TRUE(output->write_tile(x, y, 0, OIIO::TypeDesc::UINT8, texels.data())) << output->geterror();
      }
    }
  }
  ASSERT_TRUE(output->close()) << output->geterror();
}

}  // namespace feline
