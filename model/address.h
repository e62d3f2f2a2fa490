// SPDX-License-Identifier: Apache-2.0
// address: a probe to the texels, fractions and memory lines of two levels.
//
// Takes  s, t S20.24 textures; level_of_detail U4.8; linear; wrap modes, sizes, level bases.
// Gives  fine level floor(level_of_detail), coarse level one more, its weight level_fraction U0.8; for each two
//        columns, two rows U14.0 after wrapping, outside bits, fractions U0.8, and the line of each of four texels.
// Rounds linear: texel coordinate position * size to 8 fraction bits, nearest, ties up, then less half a texel.
//        nearest: down to the texel that holds the position.
// Edges  repeat: modulo 1. mirrored repeat: modulo 2, then 2 - x beyond 1. clamp to edge: to 0 .. 1. clamp to border:
//        to -1 .. 2 - 2^-24; texels outside the level are border. Sizes are max(1, size >> level). coarse_used is
//        whether level_fraction is not 0: a coarse level that weighs nothing is not touched.
// Source CS248A lecture 4, step 5; OpenGL 4.6, 8.14 (wrap modes). A line is a 4 x 4 tile of texels, lines of a level in
//        rows of tiles: line = base + (y/4) * tiles a row + x/4.
#pragma once

#include <algorithm>
#include <array>

#include "model/features.h"
#include "tables/rounding.h"
#include "tables/sampler_state.h"

namespace feline {

// Into the range that the wrap mode leaves: 0 .. 1, clamp to border -1 .. 2; raw with the position's fraction bits.
template <Config kConfig>
std::int64_t wrap_position(std::int64_t position, Wrap wrap) {
  constexpr std::int64_t kOne = std::int64_t{1} << Formats<kConfig>::kPositionFraction;
  switch (wrap) {
    case Wrap::kRepeat: return position & (kOne - 1);
    case Wrap::kMirroredRepeat: {
      const std::int64_t twice = position & (2 * kOne - 1);
      return twice >= kOne ? 2 * kOne - twice : twice;
    }
    case Wrap::kClampToEdge: return std::clamp<std::int64_t>(position, 0, kOne);
    case Wrap::kClampToBorder: return std::clamp<std::int64_t>(position, -kOne, 2 * kOne - 1);
  }
  return 0;
}

struct AxisTexels {
  std::array<std::int64_t, 2> index;
  std::array<bool, 2> outside;
  std::int64_t fraction;
};

template <Config kConfig>
AxisTexels axis_texels(std::int64_t position, std::int64_t size, Wrap wrap, bool linear) {
  using F = Formats<kConfig>;
  constexpr int kFraction = kConfig.subtexel_bits;
  constexpr int kDropped = F::kPositionFraction - kFraction;
  const std::int64_t product = wrap_position<kConfig>(position, wrap) * size;
  const std::int64_t coordinate =
      linear ? round_up_ties(product, kDropped) - (std::int64_t{1} << (kFraction - 1)) : round_down(product, kDropped);
  const std::int64_t low = round_down(coordinate, kFraction);
  const auto resolve = [&](std::int64_t index) {
    if (wrap == Wrap::kRepeat) return index < 0 ? size - 1 : index >= size ? 0 : index;
    return std::clamp<std::int64_t>(index, 0, size - 1);
  };
  const auto is_outside = [&](std::int64_t index) {
    return wrap == Wrap::kClampToBorder && (index < 0 || index >= size);
  };
  return {{resolve(low), resolve(low + 1)},
          {is_outside(low), is_outside(low + 1)},
          linear ? coordinate - (low << kFraction) : 0};
}

// Sizes of a level in texels, its tiles a row and its first memory line.
struct LevelShape {
  std::int64_t width, height, tiles_a_row, base;
  std::int64_t line(std::int64_t x, std::int64_t y) const {
    return base + (y >> kTileLog2) * tiles_a_row + (x >> kTileLog2);
  }
};

constexpr std::int64_t level_size(std::int64_t size, std::int64_t level) {
  return std::max<std::int64_t>(size >> level, 1);
}

constexpr std::int64_t tiles_a_row(std::int64_t width) {
  constexpr std::int64_t kTileMask = (std::int64_t{1} << kTileLog2) - 1;
  return (width + kTileMask) >> kTileLog2;
}

template <Config kConfig>
LevelShape level_shape(const SamplerState<kConfig>& sampler, std::int64_t level) {
  const std::int64_t width = level_size(sampler.width.raw(), level);
  const std::int64_t height = level_size(sampler.height.raw(), level);
  return {width, height, tiles_a_row(width), sampler.level_base[static_cast<std::size_t>(level)].raw()};
}

template <Config kConfig>
struct LevelTexels {
  AxisTexels x, y;
  std::array<std::int64_t, 4> line;
};

template <Config kConfig>
LevelTexels<kConfig> level_texels(const WalkBeat<kConfig>& walk, const SamplerState<kConfig>& sampler,
                                  std::int64_t level) {
  const bool linear = walk.linear.raw() != 0;
  const LevelShape shape = level_shape(sampler, level);
  LevelTexels<kConfig> texels{
      axis_texels<kConfig>(walk.s.raw(), shape.width, supported_wrap<kConfig>(sampler.wrap_s), linear),
      axis_texels<kConfig>(walk.t.raw(), shape.height, supported_wrap<kConfig>(sampler.wrap_t), linear),
      {}};
  for (std::size_t i = 0; i < 4; ++i) texels.line[i] = shape.line(texels.x.index[i % 2], texels.y.index[i / 2]);
  return texels;
}

constexpr std::int64_t border_bits(const AxisTexels& x, const AxisTexels& y) {
  return (x.outside[0] ? 1 : 0) | (x.outside[1] ? 2 : 0) | (y.outside[0] ? 4 : 0) | (y.outside[1] ? 8 : 0);
}

template <Config kConfig>
AddressBeat<kConfig> address(const WalkBeat<kConfig>& walk, const SamplerState<kConfig>& sampler) {
  AddressBeat<kConfig> beat;
  beat.tag = walk.tag;
  beat.status = walk.status;
  beat.probe = walk.probe;
  beat.first = walk.first;
  beat.last = walk.last;
  beat.weight = walk.weight;
  beat.linear = walk.linear;
  const std::int64_t level = walk.level_of_detail.raw() >> kConfig.level_fraction_bits;
  const std::int64_t fraction = walk.level_of_detail.raw() - (level << kConfig.level_fraction_bits);
  beat.level = beat.level.from_raw(level);
  beat.level_fraction = beat.level_fraction.from_raw(fraction);

  const auto store = [](const LevelTexels<kConfig>& texels, auto& xs, auto& ys, auto& border, auto& fraction_x,
                        auto& fraction_y, auto& lines) {
    for (std::size_t i = 0; i < 2; ++i) {
      xs[i] = xs[i].from_raw(texels.x.index[i]);
      ys[i] = ys[i].from_raw(texels.y.index[i]);
    }
    border = border.from_raw(border_bits(texels.x, texels.y));
    fraction_x = fraction_x.from_raw(texels.x.fraction);
    fraction_y = fraction_y.from_raw(texels.y.fraction);
    for (std::size_t i = 0; i < 4; ++i) lines[i] = lines[i].from_raw(texels.line[i]);
  };
  store(level_texels<kConfig>(walk, sampler, level), beat.fine_x, beat.fine_y, beat.fine_border, beat.fine_fraction_x,
        beat.fine_fraction_y, beat.fine_line);
  beat.coarse_used = beat.coarse_used.from_raw(fraction != 0);
  if (fraction != 0) {
    store(level_texels<kConfig>(walk, sampler, level + 1), beat.coarse_x, beat.coarse_y, beat.coarse_border,
          beat.coarse_fraction_x, beat.coarse_fraction_y, beat.coarse_line);
  }
  return beat;
}

}  // namespace feline
