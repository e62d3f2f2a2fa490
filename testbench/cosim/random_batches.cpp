// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/random_batches.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "testbench/random.h"

namespace feline {
namespace {

float from_bits(std::uint32_t bits) { return std::bit_cast<float>(bits); }

// Every class of float32, each as likely as the others.
float any_class(SplitMix64& random) {
  const std::uint32_t sign = random.below(2) << 31;
  const std::uint32_t fraction = random.below(1u << 23);
  const std::uint32_t exponent = random.below(254);
  switch (random.below(10)) {
    case 0: return from_bits(sign);
    case 1: return from_bits(sign | 0x7f800000);                   // infinity
    case 2: return from_bits(sign | 0x7f800000 | (fraction | 1));  // NaN
    case 3: return from_bits(sign | (fraction | 1));               // denormal
    case 4: return from_bits(sign | 0x00800000);                   // least normal
    case 5: return from_bits(sign | 0x7f7fffff);                   // greatest
    case 6: return from_bits(sign | (1 + exponent) << 23);         // power of two
    case 7: return from_bits(sign | (1 + exponent) << 23 | (random.below(2) != 0 ? 0x7fffff : 1));
    case 8: return from_bits(sign | (117 + exponent % 20) << 23 | random.below(16) << 19);  // few bits: ties
    default: return from_bits(static_cast<std::uint32_t>(random.next() >> 32));
  }
}

float signed_unit(SplitMix64& random) { return static_cast<float>(2 * random.unit() - 1); }

// 2^k and up to twice as much, k uniform in low .. high - 1.
float octave(SplitMix64& random, int low, int high) {
  const int exponent = low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low)));
  return std::ldexp(1.0F + static_cast<float>(random.unit()), exponent);
}

Lookup tame(SplitMix64& random, int width, int height) {
  const float size = octave(random, -3, 8);
  const float ratio = octave(random, -6, 1);
  Lookup lookup;
  lookup.s = 4 * signed_unit(random);
  lookup.t = 4 * signed_unit(random);
  lookup.dsdx = signed_unit(random) * size / static_cast<float>(width);
  lookup.dtdx = signed_unit(random) * size / static_cast<float>(height);
  lookup.dsdy = signed_unit(random) * size * ratio / static_cast<float>(width);
  lookup.dtdy = signed_unit(random) * size * ratio / static_cast<float>(height);
  // Ties of the two lengths, parallel and orthogonal gradients.
  switch (random.below(16)) {
    case 0:
      lookup.dsdy = lookup.dsdx;
      lookup.dtdy = -lookup.dtdx;
      break;
    case 1:
      lookup.dsdy = lookup.dsdx / 2;
      lookup.dtdy = lookup.dtdx / 2;
      break;
    case 2: lookup.dtdx = lookup.dsdy = 0; break;
    case 3: lookup.dsdy = lookup.dtdy = 0; break;
    default: break;
  }
  return lookup;
}

Lookup wild(SplitMix64& random) {
  return {any_class(random), any_class(random), any_class(random),
          any_class(random), any_class(random), any_class(random)};
}

constexpr std::uint32_t kOperands = 6;

float& operand(Lookup& lookup, std::uint32_t number) {
  float* const operands[kOperands] = {&lookup.s, &lookup.t, &lookup.dsdx, &lookup.dtdx, &lookup.dsdy, &lookup.dtdy};
  return *operands[number];
}

// Tame, but for one operand.
Lookup directed(SplitMix64& random, int width, int height) {
  Lookup lookup = tame(random, width, height);
  operand(lookup, random.below(kOperands)) = any_class(random);
  return lookup;
}

// Derivatives whose significands are a few high bits and one low bit, or the ones below it: what group drops of each
// is all but 0, all but a half, or all but one.
Lookup aligned(SplitMix64& random, int width, int height) {
  Lookup lookup = tame(random, width, height);
  const std::uint32_t largest = 108 + random.below(24);
  for (std::uint32_t number = 2; number < kOperands; ++number) {
    const std::uint32_t exponent = largest - random.below(random.below(2) != 0 ? 8 : 40);
    const std::uint32_t high_bits = ~((1U << 23 >> random.below(9)) - 1);
    const std::uint32_t high = random.below(1U << 23) & high_bits;
    const std::uint32_t low = 1U << random.below(23);
    const std::uint32_t significand = high | (random.below(4) != 0 ? low : low - 1);
    if (random.below(8) == 0) continue;
    operand(lookup, number) = from_bits(random.below(2) << 31 | exponent << 23 | significand);
  }
  return lookup;
}

Lookup patterned(SplitMix64& random, int width, int height, std::uint64_t number) {
  Lookup lookup = tame(random, width, height);
  operand(lookup, static_cast<std::uint32_t>(number % kOperands)) =
      float_pattern(static_cast<std::uint32_t>(number / kOperands % kFloatPatterns));
  return lookup;
}

// One tile more than the cache has columns or rows of, on some level: where such a texture repeats, tiles beside one
// another are of the same set.
int side_with_set_conflicts(SplitMix64& random) { return static_cast<int>((17 + random.below(4)) << random.below(3)); }

int random_side(SplitMix64& random) {
  switch (random.below(5)) {
    case 0: return 1 << random.below(7);
    case 1: return 1 + static_cast<int>(random.below(5));
    case 2: return side_with_set_conflicts(random);
    default: return 1 + static_cast<int>(random.below(90));
  }
}

// Of a strip: any length, often the greatest; a line of texels, or some rows of tiles, so that the length matters to
// where a row is.
int long_side(SplitMix64& random, int largest) {
  if (random.below(2) != 0) return largest - static_cast<int>(random.below(2));
  return 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(largest)));
}
int short_side(SplitMix64& random) { return 1 + static_cast<int>(random.below(random.below(2) != 0 ? 3 : 12)); }

// A texture without its texels.
struct Shape {
  TexelFormat format;
  bool srgb;
  int width, height, levels;
};

Shape random_shape(SplitMix64& random) {
  constexpr int kLargest = 1 << kUnit.max_size_log2;
  const auto format = static_cast<TexelFormat>(random.below(3));
  const bool srgb = random.below(2) != 0;
  int width = std::min(random_side(random), kLargest);
  int height = std::min(random_side(random), kLargest);
  switch (random.below(12)) {
    case 0: width = 1; break;
    case 1: height = 1; break;
    case 2: width = height = 1; break;
    case 3:
      width = long_side(random, kLargest);
      height = std::min(short_side(random), kLargest);
      break;
    case 4:
      width = std::min(short_side(random), kLargest);
      height = long_side(random, kLargest);
      break;
    default: break;
  }
  if constexpr (!kUnit.features.any_size) {
    width = static_cast<int>(std::bit_floor(static_cast<unsigned>(width)));
    height = static_cast<int>(std::bit_floor(static_cast<unsigned>(height)));
  }
  constexpr int kLevels = kUnit.max_size_log2 + 1;
  const int levels = random.below(4) == 0 ? 1 + static_cast<int>(random.below(kLevels)) : kLevels;
  return {format, srgb, width, height, levels};
}

template <typename T>
T pick(SplitMix64& random, const std::vector<T>& from) {
  return from[random.below(static_cast<std::uint32_t>(from.size()))];
}

}  // namespace

Texture random_texture(SplitMix64& random, TexelFormat format, bool srgb, int width, int height, int levels) {
  Texture texture;
  texture.format = format;
  texture.srgb = srgb;
  for (int k = 0; k < levels; ++k) {
    MipLevel level{std::max(width >> k, 1), std::max(height >> k, 1), {}};
    level.texels.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) *
                        static_cast<std::size_t>(bytes_per_texel(texture.format)));
    for (auto& byte : level.texels) byte = static_cast<std::uint8_t>(random.next() >> 56);
    texture.levels.push_back(std::move(level));
    if (texture.levels.back().width == 1 && texture.levels.back().height == 1) break;
  }
  return texture;
}

SamplerOptions random_sampler(SplitMix64& random, const SamplerChoices& choices) {
  constexpr Format kFactor = Formats<kUnit>::kFactor;
  constexpr double kLeastLength = kFactor.value(Formats<kUnit>::kLeastLengthFactor);
  SamplerOptions options;
  options.mode = pick(random, choices.modes);
  options.kernel = pick(random, choices.kernels);
  options.magnify = static_cast<Magnify>(random.below(2));
  options.wrap_s = pick(random, choices.wraps);
  options.wrap_t = pick(random, choices.wraps);
  switch (random.below(5)) {
    case 0: options.probes = kHighQuality; break;
    case 1: options.probes = kHighEfficiency; break;
    case 2:
      options.probes = {static_cast<ProbeRounding>(random.below(2)),
                        random.below(4) == 0 ? kLeastLength : kLeastLength + (1 - kLeastLength) * random.unit(),
                        1 + (1 - kFactor.value(1)) * random.unit(), 1 + random.unit()};
      break;
    case 3: options.probes.rounding = ProbeRounding::kCeiling; break;
    default: break;
  }
  if (random.below(3) == 0) options.max_probes = 1 + static_cast<int>(random.below(kUnit.max_probes));
  if (random.below(3) == 0) options.level_bias = 8 * random.unit() - 4;
  if (random.below(16) == 0) options.level_bias = random.below(2) != 0 ? -16 : kMaxLevel;
  if (random.below(4) == 0) options.max_level = kMaxLevel * random.unit();
  if (random.below(4) == 0) options.min_level = options.max_level * random.unit();
  for (auto& channel : options.border) channel = random.unit();
  return options;
}

Lookup random_lookup(SplitMix64& random, int width, int height) {
  switch (random.below(9)) {
    case 0: return wild(random);
    case 1: return aligned(random, width, height);
    case 2:
    case 3: return directed(random, width, height);
    default: return tame(random, width, height);
  }
}

namespace {

// A first line from which the texture fits, so that every bit of a line's number matters.
std::int64_t any_place(SplitMix64& random, const Texture& texture) {
  std::int64_t places = Formats<kUnit>::kLine.max_raw() + 2;
  for (const MipLevel& level : texture.levels) places -= level_lines(level.width, level.height);
  return random.below(static_cast<std::uint32_t>(places));
}

}  // namespace

RandomBatches::RandomBatches(std::uint64_t seed, std::uint64_t batch_lookups)
    : seed_(seed), batch_lookups_(batch_lookups) {}

Batch RandomBatches::make(std::uint64_t number, std::uint64_t lookups) {
  if (loaded_ != number / 2) {
    loaded_ = number / 2;
    SplitMix64 texels(derived_seed(derived_seed(seed_, 1), *loaded_));
    // Some lie where the one before lay, whose lines nothing may remember.
    const bool is_as_before = *loaded_ % 2 != 0 && texels.below(2) == 0;
    SplitMix64 random(derived_seed(derived_seed(seed_, 2), *loaded_ - (is_as_before ? 1 : 0)));
    const Shape shape = random_shape(random);
    texture_ = random_texture(texels, shape.format, shape.srgb, shape.width, shape.height, shape.levels);
    memory_ = layout_texture(texture_, anywhere_ ? any_place(random, texture_) : 0);
  }
  SplitMix64 random(derived_seed(seed_, number));
  options_ = random_sampler(random, choices_);
  const std::uint64_t first = number * batch_lookups_;
  const int width = texture_.levels.front().width;
  const int height = texture_.levels.front().height;
  lookups_.clear();
  for (std::uint64_t i = first; i < std::min(first + batch_lookups_, lookups); ++i) {
    lookups_.push_back(i % 8 == 7 ? patterned(random, width, height, i / 8) : random_lookup(random, width, height));
  }
  const bool follows = number % 2 == 0 && first + batch_lookups_ < lookups;
  // Of the textures that lie where the one before lay, half meet a flush and half a reset.
  const bool resets = *loaded_ % 4 == 1;
  Batch batch{make_sampler<kUnit>(options_, texture_, memory_), &memory_, lookups_, first, follows, {}, resets};
  if (vary_) batch.conditions = random_conditions(random);
  return batch;
}

}  // namespace feline
