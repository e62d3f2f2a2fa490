// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/profile.h"

#include <OpenImageIO/hash.h>
#include <fmt/format.h>

#include <algorithm>

#include "tables/rounding.h"
#include "testbench/error.h"

namespace feline {
namespace {

using F = Formats<kDefaultConfig>;

constexpr std::array<std::string_view, 2> kFlagNames{"no", "yes"};

// Every set of status bits.
constexpr std::array<std::string_view, 16> kStatusSetNames{"none",
                                                           "coordinate_not_finite",
                                                           "derivative_not_finite",
                                                           "coordinate_not_finite+derivative_not_finite",
                                                           "unsupported",
                                                           "coordinate_not_finite+unsupported",
                                                           "derivative_not_finite+unsupported",
                                                           "coordinate_not_finite+derivative_not_finite+unsupported",
                                                           "overflow",
                                                           "coordinate_not_finite+overflow",
                                                           "derivative_not_finite+overflow",
                                                           "coordinate_not_finite+derivative_not_finite+overflow",
                                                           "unsupported+overflow",
                                                           "coordinate_not_finite+unsupported+overflow",
                                                           "derivative_not_finite+unsupported+overflow",
                                                           "coordinate_not_finite+derivative_not_finite+unsupported+"
                                                           "overflow"};
static_assert(kStatusSetNames.size() == std::size_t{1} << kStatusNames.size());

constexpr ReachFacts named(std::string_view part, std::string_view name, std::string_view text,
                           std::span<const std::string_view> names, Each each = Each::kLookup) {
  return {part, name, text, 0, static_cast<std::int64_t>(names.size()) - 1, each, names};
}

constexpr ReachFacts raw(std::string_view part, std::string_view name, std::string_view text, const Format& format,
                         Each each = Each::kLookup) {
  return {part, name, text, format.min_raw(), format.max_raw(), each};
}

// The bits of a number's magnitude: one more than its value bits for the most negative one.
constexpr ReachFacts bits(std::string_view part, std::string_view name, std::string_view text, const Format& format,
                          Each each = Each::kLookup) {
  return {part, name, text, 0, format.width(), each};
}

void add(Histogram& into, const Histogram& from) {
  for (const auto& [value, count] : from) {
    std::uint64_t& sum = into[value];
    sum = saturating_sum(sum, count);
  }
}

bool same_shape(const TextureUse& a, const TextureUse& b) {
  return a.format == b.format && a.width == b.width && a.height == b.height && a.levels == b.levels;
}

}  // namespace

const std::array<ReachFacts, kReachCount> kReachFacts{
    named("sampler", "mode", "mode", kModeNames),
    named("sampler", "kernel", "probe kernel", kKernelNames),
    named("sampler", "magnify", "magnification filter", kMagnifyNames),
    named("sampler", "wrap", "wrap mode of s or of t; lookups with two count in both", kWrapNames, Each::kSome),
    named("sampler", "texel_format", "texel format", kTexelFormatNames),
    named("sampler", "srgb", "sRGB decoding", kFlagNames),
    named("sampler", "probe_rounding", "rounding of the probe count", kProbeRoundingNames),
    raw("sampler", "length_factor", "lengthFactor, raw: 256 is 1", F::kFactor),
    raw("sampler", "blur_factor", "blurFactor, raw: 256 is 1", F::kFactor),
    raw("sampler", "inverse_alias_factor", "1/aliasFactor, raw: 256 is 1", F::kFactor),
    {"sampler", "max_probes", "the most probes allowed", 1, kDefaultConfig.max_probes, Each::kLookup},
    raw("sampler", "level_bias", "level-of-detail bias, raw: 256 is 1", F::kLevelOfDetail),
    raw("sampler", "min_level", "least level of detail allowed, raw: 256 is 1", F::kSampledLevel),
    raw("sampler", "max_level", "greatest level of detail allowed, raw: 256 is 1", F::kSampledLevel),
    {"texture", "width", "texture width, texels", 1, std::int64_t{1} << F::kSizeBits, Each::kLookup},
    {"texture", "height", "texture height, texels", 1, std::int64_t{1} << F::kSizeBits, Each::kLookup},
    named("texture", "power_of_two", "both sides are powers of two", kFlagNames),
    {"texture", "last_level", "coarsest level in memory", 0, F::kSizeBits, Each::kLookup},
    {"request", "derivatives",
     "derivatives other than 0: 1 ds/dx, 2 dt/dx, 4 ds/dy, 8 dt/dy, added; 9 too if one is not finite", 0, 15,
     Each::kLookup},
    bits("group", "s_bits", "bits of |s|, raw", F::kPosition),
    bits("group", "t_bits", "bits of |t|, raw", F::kPosition),
    raw("group", "exponent", "exponent of a footprint that is not 0", F::kExponent, Each::kSome),
    raw("group", "dudx", "du/dx: mantissa, texels * 2^exponent", F::kMantissa),
    raw("group", "dvdx", "dv/dx: mantissa, texels * 2^exponent", F::kMantissa),
    raw("group", "dudy", "du/dy: mantissa, texels * 2^exponent", F::kMantissa),
    raw("group", "dvdy", "dv/dy: mantissa, texels * 2^exponent", F::kMantissa),
    {"footprint", "cell", "ellipse table cell, row * columns + column; lookups of mode table", 0,
     kDefaultConfig.table_rows* kDefaultConfig.table_columns - 1, Each::kSome},
    named("plan", "magnified", "the major radius is below one texel", kFlagNames),
    {"plan", "wanted_probes", "probes before a footprint wider than the smallest level takes one", 1,
     kDefaultConfig.max_probes, Each::kLookup},
    {"plan", "probes", "probes of a lookup", 1, kDefaultConfig.max_probes, Each::kLookup},
    {"plan", "weight_row", "row of the weight table", 0, F::kWeightRows - 1, Each::kLookup},
    bits("plan", "half_step_s_bits", "bits of |half step along s|, raw", F::kHalfStep),
    bits("plan", "half_step_t_bits", "bits of |half step along t|, raw", F::kHalfStep),
    {"plan", "level", "level of detail, rounded down", 0, F::kLevel.max_raw(), Each::kLookup},
    named("plan", "blended", "the level of detail lies between two levels", kFlagNames),
    named("plan", "linear", "texels are interpolated", kFlagNames),
    bits("walk", "s_bits", "bits of |s| of a probe, raw", F::kPosition, Each::kProbe),
    bits("walk", "t_bits", "bits of |t| of a probe, raw", F::kPosition, Each::kProbe),
    {"address", "fine_level", "finer level of a probe", 0, F::kLevel.max_raw(), Each::kProbe},
    {"address", "coarse_level", "coarser level of a probe that reads two", 0, F::kLevel.max_raw(), Each::kSome},
    {"address", "border_texels", "texels of a probe that lie on the border", 0, 8, Each::kProbe},
    named("fetch", "translucent", "a texel of a probe has an alpha below 255", kFlagNames, Each::kProbe),
    named("accumulate", "status", "status bits", kStatusSetNames),
};

std::string value_name(const ReachFacts& of, std::int64_t value) {
  if (of.names.empty()) return fmt::format("{}", value);
  return std::string(of.names[static_cast<std::size_t>(value - of.least)]);
}

int TextureUse::tile_columns(int level) const { return (std::max(width >> level, 1) + kTileSide - 1) / kTileSide; }

int TextureUse::tile_rows(int level) const { return (std::max(height >> level, 1) + kTileSide - 1) / kTileSide; }

std::size_t TextureUse::line_count(int level) const {
  return static_cast<std::size_t>(tile_columns(level)) * static_cast<std::size_t>(tile_rows(level));
}

std::size_t TextureUse::first_line(int level) const {
  std::size_t line = 0;
  for (int finer = 0; finer < level; ++finer) line += line_count(finer);
  return line;
}

int TextureUse::block_shift() const {
  constexpr int kMostBlocksLog2 = 6;
  return std::max(bit_length(std::max(tile_columns(0), tile_rows(0)) - 1) - kMostBlocksLog2, 0);
}

int TextureUse::block_columns() const { return ((tile_columns(0) - 1) >> block_shift()) + 1; }

int TextureUse::block_rows() const { return ((tile_rows(0) - 1) >> block_shift()) + 1; }

std::size_t TextureUse::block_count() const {
  return static_cast<std::size_t>(block_columns()) * static_cast<std::size_t>(block_rows());
}

std::uint64_t Profile::count(Reach reach, std::int64_t value) const {
  const Histogram& histogram = (*this)[reach];
  const auto found = histogram.find(value);
  return found == histogram.end() ? 0 : found->second;
}

std::uint64_t Profile::frames() const {
  std::uint64_t sum = 0;
  for (const auto& [name, frames] : sources) sum = saturating_sum(sum, frames);
  return sum;
}

std::uint64_t total(const Histogram& histogram) {
  std::uint64_t sum = 0;
  for (const auto& [value, count] : histogram) sum = saturating_sum(sum, count);
  return sum;
}

void merge(Profile& into, const Profile& from) {
  for (const auto& [hash, use] : from.textures) {
    const auto found = into.textures.find(hash);
    if (found == into.textures.end() || same_shape(found->second, use)) continue;
    bad_input("profiles", "texture " + hash, fmt::format("{} x {} texels", use.width, use.height),
              fmt::format("{} x {} texels of the same format, as before", found->second.width, found->second.height));
  }
  for (const auto& [name, frames] : from.sources) {
    std::uint64_t& sum = into.sources[name];
    sum = saturating_sum(sum, frames);
  }
  into.lookups = saturating_sum(into.lookups, from.lookups);
  into.probes = saturating_sum(into.probes, from.probes);
  for (std::size_t i = 0; i < kReachCount; ++i) add(into.reached[i], from.reached[i]);
  for (const auto& [hash, use] : from.textures) {
    const auto [found, is_new] = into.textures.try_emplace(hash, use);
    if (is_new) continue;
    found->second.names.insert(use.names.begin(), use.names.end());
    found->second.touched.insert(use.touched);
    for (std::size_t i = 0; i < use.blocks.size(); ++i) {
      found->second.blocks[i] = saturating_sum(found->second.blocks[i], use.blocks[i]);
    }
  }
}

std::string texture_hash(const Texture& texture) {
  OIIO::SHA1 hash;
  std::string shape = fmt::format("{}", static_cast<int>(texture.format));
  for (const MipLevel& level : texture.levels) shape += fmt::format(" {}x{}", level.width, level.height);
  hash.append(shape.data(), shape.size());
  for (const MipLevel& level : texture.levels) hash.append(level.texels.data(), level.texels.size());
  return hash.digest();
}

}  // namespace feline
