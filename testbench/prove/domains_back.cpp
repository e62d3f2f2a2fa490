// SPDX-License-Identifier: Apache-2.0
// Over which inputs the leaves of walk to accumulate are enumerated.
#include "model/sampler.h"
#include "testbench/prove/domains.h"
#include "testbench/prove/errors.h"
#include "testbench/random.h"

namespace feline::prove {
namespace {

using F = UnitFormats;

constexpr std::int64_t kTexture = std::int64_t{1} << F::kPositionFraction;
constexpr std::int64_t kMostSize = std::int64_t{1} << F::kSizeBits;
// Sizes up to this one are enumerated, position by position.
constexpr std::int64_t kEnumeratedSize = std::min<std::int64_t>(4096, kMostSize);

std::vector<std::int64_t> enumerated_sizes() {
  std::vector<std::int64_t> sizes;
  for (std::int64_t size = 1; size <= kEnumeratedSize; ++size) sizes.push_back(size);
  for (std::int64_t size = 2 * kEnumeratedSize; size <= kMostSize; size *= 2) sizes.push_back(size);
  return sizes;
}

// Anything: all ones, a single one, few bits, or random, with its sign.
std::int64_t any_value(SplitMix64& draw, const Format& format) {
  const int bits =
      static_cast<int>(draw.below(static_cast<std::uint32_t>(format.integer_bits + format.fraction_bits + 1)));
  const std::int64_t ones = (std::int64_t{1} << bits) - 1;
  const std::uint32_t kind = draw.below(4);
  std::int64_t value = kind == 0   ? ones
                       : kind == 1 ? (ones + 1) / 2
                                   : static_cast<std::int64_t>(draw.next() >> 1) & ones;
  value = std::min(value, format.max_raw());
  if (format.is_signed && draw.chance(0.5)) value = draw.chance(0.1) ? format.min_raw() : -value;
  return value;
}

Domain probe_weights() {
  std::vector<ProbeWeight::Inputs> inputs;
  for (std::int64_t probes = 1; probes <= kUnit.max_probes; ++probes) {
    std::vector<std::int64_t> of_probes{F::kGaussianRows + probes - 1};
    for (std::int64_t row = std::max<std::int64_t>(4 * probes - 7, 0); row <= 4 * probes - 4; ++row) {
      of_probes.push_back(row);
    }
    for (const std::int64_t row : of_probes) {
      for (std::int64_t probe = 0; probe < probes; ++probe) inputs.push_back({probes, row, probe});
    }
  }
  const std::uint64_t count = inputs.size();
  return mapped<ProbeWeight>("every probe of every row", count,
                             [inputs = std::move(inputs)](std::uint64_t i) { return inputs[i]; });
}

Domain probe_positions() {
  const auto steps = static_cast<std::uint64_t>(2 * kUnit.max_probes - 1);
  return mapped<ProbePosition>(
      "2^27 combinations, random in bits and lengths, of every probe", std::uint64_t{1} << 27, [=](std::uint64_t i) {
        SplitMix64 draw(i);
        const std::int64_t centre = any_value(draw, F::kPosition);
        return ProbePosition::Inputs{centre, any_value(draw, F::kHalfStep),
                                     static_cast<std::int64_t>(i % steps) - (kUnit.max_probes - 1)};
      });
}

// Within a texture, as repeat leaves a position.
Domain scaled_positions() {
  return product<AxisTexels>(
      "every position within a texture, interpolated, of every size to 4096 and every power of two",
      {code(Wrap::kRepeat), 1, Axis(enumerated_sizes()), Axis::range(0, kTexture - 1)});
}

Domain nearest_positions() {
  std::vector<std::int64_t> sizes;
  for (const std::int64_t size : enumerated_sizes()) {
    if (size <= 512 || (size & (size - 1)) == 0) sizes.push_back(size);
  }
  return product<AxisTexels>(
      "every position within a texture, to its texel, of every size to 512 and every power of two",
      {code(Wrap::kRepeat), 0, Axis(std::move(sizes)), Axis::range(0, kTexture - 1)});
}

Domain wrapped_positions() {
  constexpr std::array<std::int64_t, 8> kSizes{1, 2, 3, 5, 64, 1000, 4096, 16384};
  constexpr std::array<std::int64_t, 8> kFractions{0,       1,        kTexture / 2 - 1, kTexture / 2, kTexture - 1,
                                                   1 << 10, 12345678, 1 << 23};
  const auto wholes = std::uint64_t{1} << (F::kPosition.width() - F::kPositionFraction);
  const Domain every_whole =
      mapped<AxisTexels>("", wholes * kSizes.size() * kFractions.size() * 4 * 2, [=](std::uint64_t i) {
        Digits digits(i);
        const std::int64_t fraction = kFractions[static_cast<std::size_t>(digits.take(kFractions.size()))];
        const std::int64_t whole = digits.take(wholes) - static_cast<std::int64_t>(wholes / 2);
        const std::int64_t wrap = digits.take(4);
        const std::int64_t linear = digits.take(2);
        const std::int64_t size = kSizes[static_cast<std::size_t>(digits.take(kSizes.size()))];
        return AxisTexels::Inputs{wrap, linear, size, whole * kTexture + fraction % kTexture};
      });
  // Positions from two textures before to three behind.
  const Domain every_fraction = product<AxisTexels>(
      "",
      {Axis::all(F::kWrap), Axis::range(0, 1), Axis({1, 3, 1000, 16384}), Axis::range(-2 * kTexture, 3 * kTexture)});
  const Domain large =
      mapped<AxisTexels>("", static_cast<std::uint64_t>(kMostSize - kEnumeratedSize) << 14, [](std::uint64_t i) {
        SplitMix64 draw(i);
        const std::int64_t size = kEnumeratedSize + 1 + static_cast<std::int64_t>(i >> 14);
        const auto wrap = static_cast<std::int64_t>(i & 3);
        const auto linear = static_cast<std::int64_t>(i >> 2 & 1);
        // Anywhere, or beside the edge or the middle of a texel.
        const auto anywhere = static_cast<std::int64_t>(draw.next() >> (64 - F::kPositionFraction - 2)) - kTexture;
        if (draw.chance(0.5)) return AxisTexels::Inputs{wrap, linear, size, anywhere};
        const auto half_texels = static_cast<std::int64_t>(draw.below(static_cast<std::uint32_t>(2 * size + 1)));
        return AxisTexels::Inputs{wrap, linear, size, half_texels * kTexture / (2 * size) + draw.below(5) - 2};
      });
  return joined(
      "every wrap mode: every whole number of textures with eight fractions of eight sizes; every position from two "
      "textures before to three behind of four sizes; 2^14 positions of every size above 4096, half of them beside an "
      "edge or the middle of a texel",
      lane_words<AxisTexels::kInputs>(), {every_whole, every_fraction, large});
}

Domain level_lines() {
  std::vector<std::int64_t> tile_rows;
  for (std::int64_t y = 0; y < kMostSize; y += std::int64_t{1} << kTileLog2) tile_rows.push_back(y);
  const Domain rows_of_tiles = product<LevelLines>(
      "", {3, kMostSize - 1, 0, Axis(std::move(tile_rows)), Axis::range(1, kMostSize), std::int64_t{1} << 22});
  const Domain random = mapped<LevelLines>("", std::uint64_t{1} << 26, [](std::uint64_t i) {
    SplitMix64 draw(i);
    const auto index = [&] { return static_cast<std::int64_t>(draw.below(static_cast<std::uint32_t>(kMostSize))); };
    // A base from which no line leaves its format.
    return LevelLines::Inputs{index(), index(),     index(),
                              index(), 1 + index(), static_cast<std::int64_t>(draw.below(1 << 23))};
  });
  return joined("every row of tiles of every width; 2^26 random combinations", lane_words<LevelLines::kInputs>(),
                {rows_of_tiles, random});
}

Domain decoded_texels() {
  std::vector<std::int64_t> words;
  for (std::int64_t pair = 0; pair < 65536; ++pair) {
    words.push_back(pair << 16 | (pair ^ 0xffff));
    words.push_back(pair | pair << 16);
  }
  for (std::int64_t byte = 0; byte < 4; ++byte) {
    for (const std::int64_t others : {0, -1}) {
      for (std::int64_t value = 0; value < 256; ++value) {
        words.push_back(((others & ~(std::int64_t{255} << 8 * byte)) | value << 8 * byte) & 0xffffffff);
      }
    }
  }
  return product<DecodeTexel>("every code in every place, every pair of codes; every format, column, sRGB or not",
                              {Axis::range(0, 2), Axis::range(0, 1), Axis::range(0, 3), Axis(std::move(words))});
}

Domain interpolated_texels() {
  return product<InterpolateTexels>("every pair of channels at every fraction",
                                    {Axis::all(F::kChannel), Axis::all(F::kChannel), Axis::all(F::kTexelFractionOf)});
}

Domain filtered_texels() {
  return mapped<FilterTexels>(
      "2^26 combinations, random in bits and lengths; one texel in four at its greatest", std::uint64_t{1} << 26,
      [](std::uint64_t i) {
        SplitMix64 draw(i);
        FilterTexels::Inputs inputs{static_cast<std::int64_t>(i & 1), static_cast<std::int64_t>(i >> 1 & 1)};
        for (std::size_t k = 2; k < inputs.size(); ++k) {
          const bool is_texel = k >= 7;
          inputs[k] = is_texel && draw.chance(0.25) ? std::int64_t{255} << F::kChannel.fraction_bits
                                                    : any_value(draw, FilterTexels::kInputs[k]);
        }
        return inputs;
      });
}

Domain weighed_colours() {
  const Domain random = mapped<WeighColour>("", std::uint64_t{1} << 27, [](std::uint64_t i) {
    SplitMix64 draw(i);
    return WeighColour::Inputs{
        static_cast<std::int64_t>(i % 257),
        std::min(any_value(draw, F::kFiltered), std::int64_t{255} << F::kFiltered.fraction_bits)};
  });
  const Domain texels = mapped<WeighColour>("", 257 * 4081, [](std::uint64_t i) {
    Digits digits(i);
    const std::int64_t weight = digits.take(257);
    return WeighColour::Inputs{weight, digits.take(4081) << (F::kFiltered.fraction_bits - F::kChannel.fraction_bits)};
  });
  return joined("every texel with every weight; 2^27 colours, random in bits and length",
                lane_words<WeighColour::kInputs>(), {texels, random});
}

}  // namespace

void append_back_leaves(std::vector<Leaf>& leaves) {
  leaves.push_back(make_leaf<ProbeWeight>("walk.probe_weight", "probe_weight", probe_weights()));
  leaves.back().complete = true;
  leaves.back().quantities = weight_quantities();
  leaves.back().measure = &measure_weight;
  leaves.push_back(make_leaf<ProbePosition>("walk.probe_position", "probe_position", probe_positions()));
  leaves.push_back(make_leaf<LevelSize>(
      "address.level_size", "level_size",
      product<LevelSize>("every size, every level", {Axis::range(1, kMostSize), Axis::range(0, F::kLevels)})));
  leaves.back().complete = true;
  leaves.push_back(make_leaf<AxisTexels>("address.scale", "axis_texels", scaled_positions()));
  leaves.back().steady_fields = 3;
  leaves.push_back(make_leaf<AxisTexels>("address.nearest", "axis_texels", nearest_positions()));
  leaves.back().steady_fields = 3;
  leaves.push_back(make_leaf<AxisTexels>("address.wrap", "axis_texels", wrapped_positions()));
  leaves.push_back(make_leaf<LevelLines>("address.lines", "level_lines", level_lines()));
  leaves.push_back(make_leaf<DecodeTexel>("fetch.decode_texel", "decode_texel", decoded_texels()));
  leaves.push_back(make_leaf<KernelWeight>("filter.kernel_weight", "kernel_weight",
                                           product<KernelWeight>("every fraction", {Axis::all(F::kTexelFractionOf)})));
  leaves.back().complete = true;
  leaves.back().quantities = kernel_quantities();
  leaves.back().measure = &measure_kernel;
  leaves.push_back(make_leaf<InterpolateTexels>("filter.interpolate", "interpolate_texels", interpolated_texels()));
  leaves.back().complete = true;
  leaves.push_back(make_leaf<FilterTexels>("filter.texels", "filter_texels", filtered_texels()));
  leaves.push_back(make_leaf<WeighColour>("accumulate.weigh_colour", "weigh_colour", weighed_colours()));
  leaves.back().quantities = colour_quantities();
  leaves.back().measure = &measure_colour;
}

}  // namespace feline::prove
