// SPDX-License-Identifier: Apache-2.0
// fetch: lines to eight texels.
//
// Takes  lines, texel indices and outside bits of two levels; texel format, sRGB, border colour; memory.
// Gives  eight texels of red, green, blue, alpha U8.4, unit 1/255; fractions as they came.
// Rounds sRGB decoding of red, green, blue: to nearest, by table. Other texels are exact: code * 16.
// Edges  R8 gives (r, 0, 0, 1), RG8 (r, g, 0, 1); alpha is never decoded; a texel outside is the sampler state's border
//        colour, which is linear and has the format's channels only. Texels of a coarse level that is not used are 0.
//        Unsupported: alpha other than 255 where the configuration has no place for it; it is then 255.
// Source CS248A lecture 4, step 6; IEC 61966-2-1 (sRGB); OpenGL 4.6, 8.14.2 (border), table 15.1 (missing channels).
#pragma once

#include <array>

#include "model/features.h"
#include "model/memory.h"
#include "tables/roms.h"
#include "tables/sampler_state.h"

namespace feline {

// The channels that a texel has in memory; the others are the same for every texel.
template <Config kConfig>
int texel_channels(const SamplerState<kConfig>& sampler) {
  return bytes_per_texel(supported_format<kConfig>(sampler));
}

// Where a texel lies in its line, in texels.
constexpr std::size_t texel_slot(std::int64_t x, std::int64_t y) {
  return static_cast<std::size_t>(y % kTileSide * kTileSide + x % kTileSide);
}

template <Config kConfig>
typename FetchBeat<kConfig>::Texel decode_texel(std::span<const std::uint8_t> line, std::int64_t x, std::int64_t y,
                                                const SamplerState<kConfig>& sampler) {
  using Channel = Fixed<Formats<kConfig>::kChannel>;
  constexpr int kFraction = kConfig.channel_fraction_bits;
  const int channels = texel_channels<kConfig>(sampler);
  const std::size_t slot = texel_slot(x, y);
  const bool decodes = sampler.srgb.raw() != 0 && kConfig.features.srgb;
  typename FetchBeat<kConfig>::Texel texel{};
  texel[3] = Channel::from_raw(std::int64_t{255} << kFraction);
  for (int c = 0; c < channels; ++c) {
    const auto code = line[slot * static_cast<std::size_t>(channels) + static_cast<std::size_t>(c)];
    const std::int64_t value = decodes && c < 3 ? static_cast<std::int64_t>(roms<kConfig>().srgb.words[code])
                                                : std::int64_t{code} << kFraction;
    texel[static_cast<std::size_t>(c)] = Channel::from_raw(value);
  }
  return texel;
}

template <Config kConfig>
inline constexpr auto kOpaque = Fixed<Formats<kConfig>::kChannel>::from_raw(std::int64_t{255}
                                                                            << kConfig.channel_fraction_bits);

// What the configuration has no place for is 0, alpha one.
template <Config kConfig>
typename FetchBeat<kConfig>::Texel supported_texel(typename FetchBeat<kConfig>::Texel texel) {
  for (int c = 0; c < 4; ++c) {
    if (has_channel(kConfig.features, c)) continue;
    texel[static_cast<std::size_t>(c)] = c == 3 ? kOpaque<kConfig> : Fixed<Formats<kConfig>::kChannel>{};
  }
  return texel;
}

// Whether alpha is asked for by a texel of a configuration that has all channels but that one.
template <Config kConfig>
bool lacks_alpha(const typename FetchBeat<kConfig>::Texel& texel) {
  return channel_count(kConfig.features) == 4 && !kConfig.features.alpha && texel[3] != kOpaque<kConfig>;
}

template <Config kConfig>
FetchBeat<kConfig> fetch(const AddressBeat<kConfig>& address, const SamplerState<kConfig>& sampler,
                         const TextureMemory& memory) {
  FetchBeat<kConfig> beat;
  beat.tag = address.tag;
  beat.probe = address.probe;
  beat.first = address.first;
  beat.last = address.last;
  beat.weight = address.weight;
  beat.linear = address.linear;
  beat.level_fraction = address.level_fraction;
  beat.fine_fraction_x = address.fine_fraction_x;
  beat.fine_fraction_y = address.fine_fraction_y;
  beat.coarse_fraction_x = address.coarse_fraction_x;
  beat.coarse_fraction_y = address.coarse_fraction_y;

  using Texel = typename FetchBeat<kConfig>::Texel;
  const auto read = [&](const auto& xs, const auto& ys, const auto& border, const auto& lines, std::size_t i) -> Texel {
    const bool outside = ((border.raw() >> (i % 2)) & 1) != 0 || ((border.raw() >> (2 + i / 2)) & 1) != 0;
    if (outside) return sampler.border;
    return decode_texel<kConfig>(memory.line(lines[i].raw()), xs[i % 2].raw(), ys[i / 2].raw(), sampler);
  };
  bool missing = false;
  const auto cut = [&](const Texel& texel) {
    missing = missing || lacks_alpha<kConfig>(texel);
    return supported_texel<kConfig>(texel);
  };
  const std::array fine{&beat.fine_00, &beat.fine_10, &beat.fine_01, &beat.fine_11};
  const std::array coarse{&beat.coarse_00, &beat.coarse_10, &beat.coarse_01, &beat.coarse_11};
  for (std::size_t i = 0; i < 4; ++i) {
    *fine[i] = cut(read(address.fine_x, address.fine_y, address.fine_border, address.fine_line, i));
    if (address.coarse_used.raw() != 0) {
      *coarse[i] = cut(read(address.coarse_x, address.coarse_y, address.coarse_border, address.coarse_line, i));
    }
  }
  beat.status = beat.status.from_raw(address.status.raw() | unsupported_if(missing));
  return beat;
}

}  // namespace feline
