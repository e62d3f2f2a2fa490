// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "model/texture.h"

namespace feline {

// What pictures and G-buffers share of OpenImageIO. All errors are InputError naming the file, with
// OpenImageIO's words on one line.

// An open file whose first subimage is flat and has sides from 1 to kMaxImageSize.
// Throws InputError for: open, width, height, depth.
std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path);

// The channels of a file that are read, 1 to 4, and the format that they ask for, by load_texture's rules.
// Throws InputError for: channels.
int count_channels(const std::filesystem::path& path, const OIIO::ImageSpec& spec);
TexelFormat format_of(int channels);
// load_texture's rules for a file and a format that differ in channels.
MipLevel convert_channels(const MipLevel& from, int from_channels, int to_channels);

// Goes to a MIP level of the first subimage, or returns false where the file has no such level. width and height are
// those of level 0. Throws InputError for: level k, of another size than it has to be, or after 1 x 1.
bool seek_level(OIIO::ImageInput& input, const std::filesystem::path& path, int width, int height, int level);

// Reads channels [0, channels) of a MIP level of the first subimage, row-major, interleaved,
// converted to type; colours as stored, not multiplied by alpha. Throws InputError for: pixels.
void read_pixels(OIIO::ImageInput& input, const std::filesystem::path& path, int level, int channels,
                 const OIIO::TypeDesc& type, void* pixels);

// The same of a part of a level of a tiled file, as bytes: x and y are multiples of the tile's sides; so are width and
// height, or they end at the level's edge.
struct Part {
  int x = 0, y = 0, width = 0, height = 0;  // texels
};
void read_part(OIIO::ImageInput& input, const std::filesystem::path& path, int level, const Part& part, int channels,
               std::vector<std::uint8_t>& texels);

// The bytes of an image file of this kind ("png", "exr"): encoded in memory, so that every write to
// the disk goes through write_file_atomically, which checks it.
//   pixels  row-major, channels interleaved, of type spec.format
std::vector<std::byte> encode_image(const std::filesystem::path& path, std::string_view kind,
                                    const OIIO::ImageSpec& spec, const void* pixels);

}  // namespace feline
