// SPDX-License-Identifier: Apache-2.0
#include "testbench/image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/image_io.h"

namespace feline {
namespace {

// The file's own levels; one for most formats.
std::vector<MipLevel> read_levels(OIIO::ImageInput& input, const std::filesystem::path& path, int channels) {
  const int width = input.spec().width;
  const int height = input.spec().height;
  std::vector<MipLevel> levels;
  for (int level = 0; seek_level(input, path, width, height, level); ++level) {
    MipLevel read{input.spec().width, input.spec().height, {}};
    read.texels.resize(static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height) *
                       static_cast<std::size_t>(channels));
    read_pixels(input, path, level, channels, OIIO::TypeDesc::UINT8, read.texels.data());
    levels.push_back(std::move(read));
  }
  return levels;
}

template <typename Value>
std::vector<std::byte> encode(const std::filesystem::path& path, int width, int height, int channels,
                              std::span<const Value> pixels, const OIIO::TypeDesc& type) {
  if (width < 1 || height < 1 || channels < 1 || channels > 4 ||
      pixels.size() !=
          static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels)) {
    throw std::invalid_argument("write_png: the pixels do not fill the picture");
  }
  OIIO::ImageSpec spec(width, height, channels, type);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return encode_image(path, "png", spec, pixels.data());
}

}  // namespace

Texture load_texture(const std::filesystem::path& path, const ImageOptions& options) {
  const auto input = open_image(path);
  const int file_channels = count_channels(path, input->spec());
  Texture texture{options.format.value_or(format_of(file_channels)), options.srgb,
                  read_levels(*input, path, file_channels)};
  const int channels = bytes_per_texel(texture.format);
  if (channels != file_channels) {
    for (MipLevel& level : texture.levels) level = convert_channels(level, file_channels, channels);
  }
  if (texture.levels.size() == 1) {
    texture.levels = build_mip_chain(std::move(texture.levels.front()), channels, options.mip_filter, options.srgb,
                                     options.mip_edge);
  }
  return texture;
}

std::vector<std::byte> encode_png(const std::filesystem::path& path, int width, int height, int channels,
                                  std::span<const std::uint8_t> pixels) {
  return encode(path, width, height, channels, pixels, OIIO::TypeDesc::UINT8);
}

void write_png(const std::filesystem::path& path, int width, int height, int channels,
               std::span<const std::uint8_t> pixels) {
  write_file_atomically(path, encode_png(path, width, height, channels, pixels));
}

void write_png(const std::filesystem::path& path, int width, int height, int channels,
               std::span<const std::uint16_t> pixels) {
  write_file_atomically(path, encode(path, width, height, channels, pixels, OIIO::TypeDesc::UINT16));
}

void write_png(OutputFiles& outputs, const std::filesystem::path& path, int width, int height, int channels,
               std::span<const std::uint8_t> pixels) {
  outputs.write(path, encode_png(path, width, height, channels, pixels));
}

}  // namespace feline
