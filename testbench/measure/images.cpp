// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/images.h"

#include <algorithm>
#include <array>

#include "testbench/srgb.h"

namespace feline {
namespace {

std::array<float, 256> decoded_codes(bool srgb) {
  std::array<float, 256> codes{};
  for (std::size_t code = 0; code < codes.size(); ++code) {
    const double encoded = static_cast<double>(code) / 255;
    codes[code] = static_cast<float>(srgb ? srgb_to_linear(encoded) : encoded);
  }
  return codes;
}

}  // namespace

reference::Level to_reference(const MipLevel& level, TexelFormat format, bool srgb) {
  const std::array<float, 256> colour = decoded_codes(srgb);
  const std::array<float, 256> alpha = decoded_codes(false);
  const auto channels = static_cast<std::size_t>(bytes_per_texel(format));
  reference::Level result{level.width, level.height, {}};
  result.texels.reserve(level.texels.size() / channels);
  for (std::size_t i = 0; i < level.texels.size(); i += channels) {
    reference::Texel texel{0, 0, 0, 1};
    for (std::size_t c = 0; c < channels; ++c) texel[c] = (c == 3 ? alpha : colour)[level.texels[i + c]];
    result.texels.push_back(texel);
  }
  return result;
}

reference::MipMap to_reference(const Texture& texture, const reference::Wrapping& wrapping) {
  reference::MipMap map{{}, wrapping};
  for (const MipLevel& level : texture.levels) map.levels.push_back(to_reference(level, texture.format, texture.srgb));
  for (std::size_t c = static_cast<std::size_t>(bytes_per_texel(texture.format)); c < 4; ++c) {
    map.wrapping.border[c] = c == 3 ? 1 : 0;
  }
  return map;
}

reference::Images make_images(const Texture& texture, const reference::Wrapping& wrapping, MipEdge edge,
                              std::span<const reference::Pyramid> wanted) {
  const auto wants = [&](reference::Pyramid pyramid) { return std::ranges::find(wanted, pyramid) != wanted.end(); };
  const int channels = bytes_per_texel(texture.format);
  const MipLevel& base = texture.levels.front();
  reference::Images images;
  images.lanczos = to_reference(texture, wrapping);
  if (wants(reference::Pyramid::kBox)) {
    images.box = to_reference(
        Texture{texture.format, texture.srgb, build_mip_chain(base, channels, MipFilter::kBox, texture.srgb, edge)},
        wrapping);
  }
  if (wants(reference::Pyramid::kRip)) {
    const RipChain rip = build_rip_chain(base, channels, MipFilter::kLanczos, texture.srgb, edge);
    images.rip = {rip.columns, rip.rows, {}, images.lanczos.wrapping};
    for (const MipLevel& image : rip.images) {
      images.rip.levels.push_back(to_reference(image, texture.format, texture.srgb));
    }
  }
  return images;
}

}  // namespace feline
