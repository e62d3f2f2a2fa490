// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "model/memory.h"
#include "model/sampler.h"
#include "testbench/image.h"

namespace feline {

// How much of a texture is in memory.
struct Residency {
  std::int64_t tiles = 0;         // of the file, loaded
  std::int64_t whole_tiles = 0;   // of the file
  std::int64_t levels = 0;        // of which any tile is loaded
  std::int64_t whole_levels = 0;  // of the file
  std::int64_t bytes = 0;         // lines and the table that finds them
  std::int64_t whole_bytes = 0;   // of layout_texture's memory
};

// A texture file that has tiles and MIP levels of its own (.tx, tiled TIFF, tiled OpenEXR) as memory that loads a tile
// of the file when a line in it is first asked for, and keeps it. Lines are those of layout_texture(load_texture()).
// For one thread.
class LazyTexture {
 public:
  // Null when the file has to be loaded whole: it has no tiles, a single level, or tiles whose sides are no multiples
  // of a line's 4 texels. Throws InputError as load_texture does.
  static std::unique_ptr<LazyTexture> open(const std::filesystem::path& path, const ImageOptions& options = {});
  LazyTexture(const LazyTexture&) = delete;
  LazyTexture& operator=(const LazyTexture&) = delete;
  ~LazyTexture();

  const TextureShape& shape() const { return shape_; }
  // A line of 64 bytes, index from 0 to all levels' lines; valid as long as the object. Throws InputError when the
  // file's tile cannot be read: pixels.
  std::span<const std::uint8_t> line(std::int64_t index) {
    if (index != last_index_) find_line(index);
    return {last_line_, kLineBytes};
  }
  // Its file has no alpha.
  bool opaque() const { return shape_.format == TexelFormat::kRgba8 && file_channels_ < 4; }
  Residency residency() const;

 private:
  struct Level;
  LazyTexture();
  void find_line(std::int64_t index);
  void load_tile(Level& level, std::size_t tile);

  std::filesystem::path path_;
  TextureShape shape_;
  int file_channels_ = 0;
  std::vector<Level> levels_;
  std::int64_t last_index_ = -1;
  const std::uint8_t* last_line_ = nullptr;
};

}  // namespace feline
