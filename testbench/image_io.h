// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace feline {

// What pictures and G-buffers share of OpenImageIO. All errors are InputError naming the file, with
// OpenImageIO's words on one line.

// An open file whose first subimage is flat and has sides from 1 to kMaxImageSize.
// Throws InputError for: open, width, height, depth.
std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path);

// Reads channels [0, channels) of a MIP level of the first subimage, row-major, interleaved,
// converted to type; colours as stored, not multiplied by alpha. Throws InputError for: pixels.
void read_pixels(OIIO::ImageInput& input, const std::filesystem::path& path, int level, int channels,
                 const OIIO::TypeDesc& type, void* pixels);

// The bytes of an image file of this kind ("png", "exr"): encoded in memory, so that every write to
// the disk goes through write_file_atomically, which checks it.
//   pixels  row-major, channels interleaved, of type spec.format
std::vector<std::byte> encode_image(const std::filesystem::path& path, std::string_view kind,
                                    const OIIO::ImageSpec& spec, const void* pixels);

}  // namespace feline
