// SPDX-License-Identifier: Apache-2.0
// Image files with tiles and MIP levels, loaded as they are touched: the lines of the whole texture, or InputError.
#include <array>
#include <optional>

#include "testbench/lazy_texture.h"
#include "tests/fuzz/images.h"

namespace feline {
namespace {

constexpr std::array<const char*, 2> kNames{"tiled.tif", "tiled.exr"};

std::optional<TextureMemory> whole(const std::filesystem::path& path) {
  std::optional<TextureMemory> memory;
  fuzz::accepts([&] { memory = layout_texture(load_texture(path)); });
  return memory;
}

// Of a tile that ends before its texels do OpenEXR 3.1.5 reads the rest from what its buffer held before, without an
// error: "broken contract: LazyTexture: lines of load_texture" of 49 bytes for 5 x 5 halves. So TIFF's are compared.
void compare(LazyTexture& lazy, const std::optional<TextureMemory>& memory, bool texels) {
  const TextureShape& shape = lazy.shape();
  std::int64_t lines = 0;
  for (int level = 0; level < shape.levels; ++level) {
    fuzz::require(shape.level_base[static_cast<std::size_t>(level)] == lines, "LazyTexture: levels follow each other");
    lines += level_lines(mip_size(shape.width, level), mip_size(shape.height, level));
  }
  if (memory) fuzz::require(memory->level_base == shape.level_base, "LazyTexture: levels as of load_texture");
  for (std::int64_t line = 0; line < lines; ++line) {
    const bool read = fuzz::accepts([&] {
      const auto bytes = lazy.line(line);
      if (memory && texels)
        fuzz::require(std::ranges::equal(bytes, memory->line(line)), "LazyTexture: lines of load_texture");
    });
    fuzz::require(read || !memory, "LazyTexture: reads what load_texture reads");
  }
}

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  limit_openimageio();
  const char* const name = input.choose<const char* const>(kNames);
  const auto path = file_with(name, input.rest());
  accepts([&] {
    if (!is_small(path, input.rest())) return;
    if (const auto lazy = LazyTexture::open(path)) compare(*lazy, whole(path), path.extension() == ".tif");
  });
}
