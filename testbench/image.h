// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "model/texture.h"
#include "testbench/atomic_file.h"
#include "testbench/mip_chain.h"

namespace feline {

// The largest side of a texture or a picture, in texels or pixels (Vulkan Roadmap 2022, D3D11.3).
inline constexpr int kMaxImageSize = 16384;

struct ImageOptions {
  bool srgb = false;                                 // colours are sRGB encoded; goes to Texture::srgb
  MipFilter mip_filter = MipFilter::kLanczos;        // for a file without its own levels
  MipEdge mip_edge = MipEdge::kClamp;                // as the sampler will wrap
  std::optional<TexelFormat> format = std::nullopt;  // otherwise by the file's channels
};

// Reads any image that OpenImageIO reads, as 8 bit unorm, with its mip chain.
// Channels: 1 gives R8, 2 RG8, 3 RGBA8 with alpha 255, 4 RGBA8; more than 4 are an error, unless the
// first four are R, G, B, A, which are then taken. options.format overrides: fewer channels keep
// the first ones; more repeat a single channel as grey, have blue 0 otherwise, alpha 255.
// Colours are as the file stores them: not multiplied by alpha in PNG, multiplied in OpenEXR. Wider
// types are scaled and clamped.
// A file with several MIP levels (.tx) brings its own, each max(1, w >> k) by max(1, h >> k); the
// last one may be larger than 1 x 1. Otherwise build_mip_chain makes them.
// Throws InputError naming the file and: open (missing, not an image), width or height (legal is 1
// to 16384), channels, depth, level k, pixels (corrupt or truncated data, in OpenImageIO's words).
Texture load_texture(const std::filesystem::path& path, const ImageOptions& options = {});

// A PNG, whole or not at all, the same bytes for the same pixels: no dates, no names.
//   pixels    row-major, channels interleaved, unorm, sRGB encoded where they are colours
//   channels  1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; alpha is unassociated
// Throws InputError when the file cannot be written, std::invalid_argument when the pixels do not
// fill the size.
void write_png(const std::filesystem::path& path, int width, int height, int channels,
               std::span<const std::uint8_t> pixels);
void write_png(const std::filesystem::path& path, int width, int height, int channels,
               std::span<const std::uint16_t> pixels);
// The bytes of such a file.
std::vector<std::byte> encode_png(const std::filesystem::path& path, int width, int height, int channels,
                                  std::span<const std::uint8_t> pixels);
// The same as one of several outputs.
void write_png(OutputFiles& outputs, const std::filesystem::path& path, int width, int height, int channels,
               std::span<const std::uint8_t> pixels);

}  // namespace feline
