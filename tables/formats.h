// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "tables/config.h"
#include "tables/format.h"
#include "tables/sampler_enums.h"

namespace feline {

// The bits that hold the values 0 .. count - 1.
constexpr int bits_for(std::size_t count) {
  int bits = 1;
  while ((std::size_t{1} << bits) < count) ++bits;
  return bits;
}
constexpr int bits_for(int count) { return bits_for(static_cast<std::size_t>(count)); }

// Of the full unit, from which a smaller one must not differ without a flag: bits of the group exponent, and where
// clamped coordinates saturate, 2^19 textures.
inline constexpr int kFullExponentBits = 6;
inline constexpr int kFullRangeLog2 = 19;

// A 4 x 4 tile of texels is one memory line.
inline constexpr int kTileLog2 = 2;

// Every number of the machine that follows from a configuration. Each width is stated or derived here and nowhere else.
struct FormatSet {
  int magnitude_bits, size_bits, probe_bits, texel_fraction, filter_fraction;
  int levels, gaussian_rows, weight_rows, weight_columns;
  // Probes reach at most 2^reach_log2 from the centre, in normalized units: a line of more than one probe has a minor
  // radius of at most 2^max_size_log2 texels and a major radius of at most (max_probes + 1)/2 * aliasFactor of it, and
  // aliasFactor <= 2; the texture may be one texel wide. Where no coordinate is clamped, positions count modulo 4 only.
  int reach_log2;
  // Clamped coordinates saturate where no probe can come back into the texture, or farther away if so configured.
  int saturation_log2;
  int position_fraction;
  // Inside plan: floor(8 major/minor), saturated where the weight row no longer changes, and twice the major radius
  // times a factor, without the factor's fraction.
  int eighths_width, dividend_width;
  std::int64_t least_length_factor;

  Format tag, flag, status, float32;
  Format mantissa, exponent, radius, vector, position, half_step;
  Format level_of_detail, sampled_level, level_fraction, level, full_level;
  Format probe_count, probe_index, weight_row, weight;
  Format table_scale, table_fraction, factor, reciprocal, line_fraction, size_reciprocal, size_shift;
  Format size, texel_index, texel_fraction_of, line;
  Format channel, filtered, accumulated, pixel;
  Format mode, wrap, texel_format;

  constexpr explicit FormatSet(const Config& config)
      : magnitude_bits(config.mantissa_bits - 1),
        size_bits(config.max_size_log2),
        probe_bits(bits_for(config.max_probes)),
        texel_fraction(config.channel_fraction_bits),
        filter_fraction(2 * config.subtexel_bits + config.level_fraction_bits),
        levels(config.max_levels > size_bits ? size_bits + 1 : config.max_levels),
        gaussian_rows(4 * config.max_probes - 3),
        weight_rows(gaussian_rows + config.max_probes),
        weight_columns(config.max_probes / 2 + 1),
        reach_log2(config.features.clamp_to_edge || config.features.clamp_to_border ? size_bits + probe_bits : 0),
        saturation_log2(std::max(reach_log2 + 1, config.least_range_log2)),
        position_fraction(size_bits + config.subtexel_bits + config.guard_bits),
        eighths_width(bits_for(4 * config.max_probes + 8)),
        dividend_width(magnitude_bits + 1 + kLengthFraction + 2),
        // A footprint that is not 0 has a mantissa of at least half the greatest. Shortened, spread over the most
        // probes and aliased by 2, its radius must not vanish, or its level of detail would have no bound.
        least_length_factor((((std::int64_t{config.max_probes} + 1) << config.factor_bits) +
                             (std::int64_t{1} << least_major_log2()) - 1) >>
                            least_major_log2()),
        tag{"tag", false, config.tag_bits, 0, "lookup"},
        flag{"flag", false, 1, 0, "truth"},
        status{"status", false, static_cast<int>(kStatusNames.size()), 0, "bits"},
        float32{"float32", false, 32, 0, "IEEE 754 bits"},
        mantissa{"mantissa", true, magnitude_bits, 0, "texel * 2^exponent"},
        exponent{"exponent", true, config.exponent_bits, 0, "octave"},
        radius{"radius", false, magnitude_bits + 1, kLengthFraction, "texel * 2^exponent"},
        vector{"vector", true, magnitude_bits + 1, config.entry_bits, "texel * 2^exponent"},
        position{"position", true, saturation_log2 + 1, position_fraction, "texture"},
        half_step{"half_step", true, reach_log2 + 1, position_fraction, "texture"},
        level_of_detail{"level_of_detail", true, 5, config.level_fraction_bits, "octave"},
        sampled_level{"sampled_level", false, bits_for(levels), config.level_fraction_bits, "octave"},
        level_fraction{"level_fraction", false, 0, config.level_fraction_bits, "octave"},
        level{"level", false, bits_for(levels), 0, "level"},
        full_level{"full_level", false, bits_for(size_bits + 1), 0, "level"},
        probe_count{"probe_count", false, bits_for(config.max_probes + 1), 0, "probe"},
        probe_index{"probe_index", false, probe_bits, 0, "probe"},
        weight_row{"weight_row", false, bits_for(weight_rows), 0, "row"},
        weight{"weight", false, 1, config.weight_bits, "pixel"},
        table_scale{"table_scale", false, 1, config.entry_bits - 1, "longer vector"},
        table_fraction{"table_fraction", false, 0, config.entry_bits, "longer vector"},
        factor{"factor", false, 1, config.factor_bits, "ratio"},
        reciprocal{"reciprocal", false, 1, config.reciprocal_bits, "ratio"},
        line_fraction{"line_fraction", false, 1, config.line_bits, "major radius"},
        size_reciprocal{"size_reciprocal", false, 1, config.size_reciprocal_bits, "texture/texel"},
        size_shift{"size_shift", false, bits_for(size_bits + 1), 0, "octave"},
        size{"size", false, size_bits + 1, 0, "texel"},
        texel_index{"texel_index", false, size_bits, 0, "texel"},
        texel_fraction_of{"texel_fraction", false, 0, config.subtexel_bits, "texel"},
        line{"line", false, 2 * (size_bits - kTileLog2) + 1, 0, "memory line"},
        channel{"channel", false, 8, texel_fraction, "1/255"},
        filtered{"filtered", false, 8, texel_fraction + filter_fraction, "1/255"},
        accumulated{"accumulated", false, 8, texel_fraction + filter_fraction + config.weight_bits, "1/255"},
        pixel{"pixel", false, 8, config.pixel_fraction_bits, "1/255"},
        mode{"mode", false, bits_for(kModeNames.size()), 0, "code"},
        wrap{"wrap", false, bits_for(kWrapNames.size()), 0, "code"},
        texel_format{"texel_format", false, bits_for(kTexelFormatNames.size()), 0, "code"} {}

  // All of them, for the generated package.
  constexpr std::array<Format, 37> all() const {
    return {tag,
            flag,
            status,
            float32,
            mantissa,
            exponent,
            radius,
            vector,
            position,
            half_step,
            level_of_detail,
            sampled_level,
            level_fraction,
            level,
            full_level,
            probe_count,
            probe_index,
            weight_row,
            weight,
            table_scale,
            table_fraction,
            factor,
            reciprocal,
            line_fraction,
            size_reciprocal,
            size_shift,
            size,
            texel_index,
            texel_fraction_of,
            line,
            channel,
            filtered,
            accumulated,
            pixel,
            mode,
            wrap,
            texel_format};
  }

  // The coefficients of the two-part linear length are multiples of 1/128 (Feline 3.2).
  static constexpr int kLengthFraction = 7;

 private:
  constexpr int least_major_log2() const { return magnitude_bits - 1 + kLengthFraction; }
};

// The same as constants, which types are made of.
template <Config kConfig>
struct Formats : LegalConfig<kConfig> {
  static constexpr FormatSet kSet{kConfig};
  static constexpr int kMagnitudeBits = kSet.magnitude_bits;
  static constexpr int kSizeBits = kSet.size_bits;
  static constexpr int kLevels = kSet.levels;
  static constexpr int kGaussianRows = kSet.gaussian_rows;
  static constexpr int kWeightRows = kSet.weight_rows;
  static constexpr int kWeightColumns = kSet.weight_columns;
  static constexpr int kReachLog2 = kSet.reach_log2;
  static constexpr int kSaturationLog2 = kSet.saturation_log2;
  static constexpr int kPositionFraction = kSet.position_fraction;
  static constexpr std::int64_t kLeastLengthFactor = kSet.least_length_factor;

  static constexpr Format kTag = kSet.tag;
  static constexpr Format kFlag = kSet.flag;
  static constexpr Format kStatus = kSet.status;
  static constexpr Format kFloat = kSet.float32;
  static constexpr Format kMantissa = kSet.mantissa;
  static constexpr Format kExponent = kSet.exponent;
  static constexpr Format kRadius = kSet.radius;
  static constexpr Format kVector = kSet.vector;
  static constexpr Format kPosition = kSet.position;
  static constexpr Format kHalfStep = kSet.half_step;
  static constexpr Format kLevelOfDetail = kSet.level_of_detail;
  static constexpr Format kSampledLevel = kSet.sampled_level;
  static constexpr Format kLevelFraction = kSet.level_fraction;
  static constexpr Format kLevel = kSet.level;
  static constexpr Format kFullLevel = kSet.full_level;
  static constexpr Format kProbeCount = kSet.probe_count;
  static constexpr Format kProbeIndex = kSet.probe_index;
  static constexpr Format kWeightRow = kSet.weight_row;
  static constexpr Format kWeight = kSet.weight;
  static constexpr Format kTableScale = kSet.table_scale;
  static constexpr Format kTableFraction = kSet.table_fraction;
  static constexpr Format kFactor = kSet.factor;
  static constexpr Format kReciprocal = kSet.reciprocal;
  static constexpr Format kLineFraction = kSet.line_fraction;
  static constexpr Format kSizeReciprocal = kSet.size_reciprocal;
  static constexpr Format kSizeShift = kSet.size_shift;
  static constexpr Format kSize = kSet.size;
  static constexpr Format kTexelIndex = kSet.texel_index;
  static constexpr Format kTexelFractionOf = kSet.texel_fraction_of;
  static constexpr Format kLine = kSet.line;
  static constexpr Format kChannel = kSet.channel;
  static constexpr Format kFiltered = kSet.filtered;
  static constexpr Format kAccumulated = kSet.accumulated;
  static constexpr Format kPixel = kSet.pixel;
  static constexpr Format kMode = kSet.mode;
  static constexpr Format kWrap = kSet.wrap;
  static constexpr Format kTexelFormat = kSet.texel_format;
};

}  // namespace feline
