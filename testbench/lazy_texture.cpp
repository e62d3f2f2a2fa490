// SPDX-License-Identifier: Apache-2.0
#include "testbench/lazy_texture.h"

#include <algorithm>
#include <utility>

#include "testbench/image_io.h"

namespace feline {
namespace {

constexpr int tiles_over(int texels, int tile) { return (texels + tile - 1) / tile; }

}  // namespace

// A level and what of it is loaded: for each tile of the file its lines, row by row, or null.
struct LazyTexture::Level {
  int number = 0;
  int width = 0, height = 0;            // texels
  int tile_width = 0, tile_height = 0;  // texels
  std::int64_t base = 0;                // first line
  std::unique_ptr<OIIO::ImageInput> input;
  std::vector<std::unique_ptr<std::uint8_t[]>> tiles;

  int columns() const { return tiles_over(width, tile_width); }
  int rows() const { return tiles_over(height, tile_height); }
  // What tile number i covers.
  Part part(std::size_t i) const {
    const int x = static_cast<int>(i) % columns() * tile_width;
    const int y = static_cast<int>(i) / columns() * tile_height;
    return {x, y, std::min(tile_width, width - x), std::min(tile_height, height - y)};
  }
};

LazyTexture::LazyTexture() = default;
LazyTexture::~LazyTexture() = default;

std::unique_ptr<LazyTexture> LazyTexture::open(const std::filesystem::path& path, const ImageOptions& options) {
  auto input = open_image(path);
  std::unique_ptr<LazyTexture> texture(new LazyTexture);
  texture->path_ = path;
  texture->file_channels_ = count_channels(path, input->spec());
  TextureShape& shape = texture->shape_;
  shape = {options.format.value_or(format_of(texture->file_channels_)),
           options.srgb,
           input->spec().width,
           input->spec().height,
           0,
           {}};
  std::int64_t lines = 0;
  while (seek_level(*input, path, shape.width, shape.height, shape.levels)) {
    const OIIO::ImageSpec& spec = input->spec();
    const bool by_lines = spec.tile_width > 0 && spec.tile_height > 0 && spec.tile_depth <= 1 &&
                          spec.tile_width % kTileSide == 0 && spec.tile_height % kTileSide == 0;
    if (!by_lines) return nullptr;
    Level& level = texture->levels_.emplace_back();
    level.number = shape.levels++;
    level.width = spec.width;
    level.height = spec.height;
    level.tile_width = spec.tile_width;
    level.tile_height = spec.tile_height;
    level.base = lines;
    level.tiles.resize(static_cast<std::size_t>(level.columns()) * static_cast<std::size_t>(level.rows()));
    shape.level_base.push_back(lines);
    lines += level_lines(level.width, level.height);
  }
  return shape.levels > 1 ? std::move(texture) : nullptr;
}

void LazyTexture::find_line(std::int64_t index) {
  auto level = levels_.end() - 1;
  while (level->base > index) --level;
  const int lines_a_row = tiles_over(level->width, kTileSide);
  const auto number = static_cast<int>(index - level->base);
  const int x = number % lines_a_row * kTileSide;
  const int y = number / lines_a_row * kTileSide;
  const auto tile = static_cast<std::size_t>(y / level->tile_height * level->columns() + x / level->tile_width);
  if (!level->tiles[tile]) load_tile(*level, tile);
  const Part part = level->part(tile);
  const int line = (y - part.y) / kTileSide * tiles_over(part.width, kTileSide) + (x - part.x) / kTileSide;
  last_line_ = level->tiles[tile].get() + static_cast<std::ptrdiff_t>(line) * kLineBytes;
  last_index_ = index;
}

void LazyTexture::load_tile(Level& level, std::size_t tile) {
  if (!level.input) level.input = open_image(path_);
  const Part part = level.part(tile);
  Texture texture{shape_.format, shape_.srgb, {{part.width, part.height, {}}}};
  MipLevel& texels = texture.levels.front();
  read_part(*level.input, path_, level.number, part, file_channels_, texels.texels);
  const int channels = bytes_per_texel(shape_.format);
  if (channels != file_channels_) texels = convert_channels(texels, file_channels_, channels);
  const TextureMemory memory = layout_texture(texture);
  level.tiles[tile] = std::make_unique_for_overwrite<std::uint8_t[]>(memory.bytes.size());
  std::ranges::copy(memory.bytes, level.tiles[tile].get());
}

Residency LazyTexture::residency() const {
  Residency residency;
  for (const Level& level : levels_) {
    residency.bytes += static_cast<std::int64_t>(sizeof(level) + level.tiles.capacity() * sizeof(level.tiles[0]));
    residency.whole_bytes += level_lines(level.width, level.height) * kLineBytes;
    residency.whole_tiles += static_cast<std::int64_t>(level.tiles.size());
    ++residency.whole_levels;
    std::int64_t loaded = 0;
    for (std::size_t tile = 0; tile < level.tiles.size(); ++tile) {
      if (!level.tiles[tile]) continue;
      const Part part = level.part(tile);
      residency.bytes += level_lines(part.width, part.height) * kLineBytes;
      ++loaded;
    }
    residency.tiles += loaded;
    residency.levels += loaded > 0 ? 1 : 0;
  }
  return residency;
}

}  // namespace feline
