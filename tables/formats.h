// SPDX-License-Identifier: Apache-2.0
#pragma once

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

// A 4 x 4 tile of texels is one memory line.
inline constexpr int kTileLog2 = 2;

// Every format of the machine. Each width is stated or derived here and nowhere else.
template <Config kConfig>
struct Formats : LegalConfig<kConfig> {
  static constexpr int kMagnitudeBits = kConfig.mantissa_bits - 1;
  static constexpr int kSizeBits = kConfig.max_size_log2;
  static constexpr int kProbeBits = bits_for(kConfig.max_probes);
  static constexpr int kTexelFraction = kConfig.channel_fraction_bits;
  static constexpr int kFilterFraction = 2 * kConfig.subtexel_bits + kConfig.level_fraction_bits;
  // The coefficients of the two-part linear length are multiples of 1/128 (Feline 3.2).
  static constexpr int kLengthFraction = 7;
  static constexpr int kLevels = kConfig.max_size_log2 + 1;
  static constexpr int kGaussianRows = 4 * kConfig.max_probes - 3;
  static constexpr int kWeightRows = kGaussianRows + kConfig.max_probes;
  static constexpr int kWeightColumns = kConfig.max_probes / 2 + 1;
  // Probes reach at most 2^kReachLog2 from the centre, in normalized units: a line of more than one probe has a minor
  // radius of at most 2^max_size_log2 texels and a major radius of at most (max_probes + 1)/2 * aliasFactor of it, and
  // aliasFactor <= 2; the texture may be one texel wide.
  static constexpr int kReachLog2 = kSizeBits + kProbeBits;
  // Clamped coordinates saturate where no probe can come back into the texture.
  static constexpr int kSaturationLog2 = kReachLog2 + 1;
  static constexpr int kPositionFraction = kSizeBits + kConfig.subtexel_bits + kConfig.guard_bits;

  static constexpr Format kTag{"tag", false, kConfig.tag_bits, 0, "lookup"};
  static constexpr Format kFlag{"flag", false, 1, 0, "truth"};
  static constexpr Format kStatus{"status", false, static_cast<int>(kStatusNames.size()), 0, "bits"};
  static constexpr Format kFloat{"float32", false, 32, 0, "IEEE 754 bits"};

  static constexpr Format kMantissa{"mantissa", true, kMagnitudeBits, 0, "texel * 2^exponent"};
  static constexpr Format kExponent{"exponent", true, 6, 0, "octave"};
  static constexpr Format kRadius{"radius", false, kMagnitudeBits + 1, kLengthFraction, "texel * 2^exponent"};
  static constexpr Format kVector{"vector", true, kMagnitudeBits + 1, kConfig.entry_bits, "texel * 2^exponent"};
  static constexpr Format kPosition{"position", true, kSaturationLog2 + 1, kPositionFraction, "texture"};
  static constexpr Format kHalfStep{"half_step", true, kReachLog2 + 1, kPositionFraction, "texture"};
  static constexpr Format kLevelOfDetail{"level_of_detail", true, 5, kConfig.level_fraction_bits, "octave"};
  static constexpr Format kSampledLevel{"sampled_level", false, bits_for(kLevels), kConfig.level_fraction_bits,
                                        "octave"};
  static constexpr Format kLevelFraction{"level_fraction", false, 0, kConfig.level_fraction_bits, "octave"};
  static constexpr Format kLevel{"level", false, bits_for(kLevels), 0, "level"};
  static constexpr Format kProbeCount{"probe_count", false, bits_for(kConfig.max_probes + 1), 0, "probe"};
  static constexpr Format kProbeIndex{"probe_index", false, kProbeBits, 0, "probe"};
  static constexpr Format kWeightRow{"weight_row", false, bits_for(kWeightRows), 0, "row"};
  static constexpr Format kWeight{"weight", false, 1, kConfig.weight_bits, "pixel"};

  static constexpr Format kTableScale{"table_scale", false, 1, kConfig.entry_bits - 1, "longer vector"};
  static constexpr Format kTableFraction{"table_fraction", false, 0, kConfig.entry_bits, "longer vector"};
  static constexpr Format kFactor{"factor", false, 1, kConfig.factor_bits, "ratio"};
  // A footprint that is not 0 has a mantissa of at least half the greatest. Shortened, spread over the most probes and
  // aliased by 2, its radius must not vanish, or its level of detail would have no bound.
  static constexpr int kLeastMajorLog2 = kMagnitudeBits - 1 + kLengthFraction;
  static constexpr std::int64_t kLeastLengthFactor =
      (((std::int64_t{kConfig.max_probes} + 1) << kConfig.factor_bits) + (std::int64_t{1} << kLeastMajorLog2) - 1) >>
      kLeastMajorLog2;
  // Inside plan: floor(8 major/minor), saturated where the weight row no longer changes, and twice the major radius
  // times a factor, without the factor's fraction.
  static constexpr int kEighthsWidth = bits_for(4 * kConfig.max_probes + 8);
  static constexpr int kDividendWidth = kRadius.width() + kFactor.width() + 1 - kFactor.fraction_bits;
  static constexpr Format kReciprocal{"reciprocal", false, 1, kConfig.reciprocal_bits, "ratio"};
  static constexpr Format kLineFraction{"line_fraction", false, 1, kConfig.line_bits, "major radius"};
  static constexpr Format kSizeReciprocal{"size_reciprocal", false, 1, kConfig.size_reciprocal_bits, "texture/texel"};
  static constexpr Format kSizeShift{"size_shift", false, bits_for(kSizeBits + 1), 0, "octave"};

  static constexpr Format kSize{"size", false, kSizeBits + 1, 0, "texel"};
  static constexpr Format kTexelIndex{"texel_index", false, kSizeBits, 0, "texel"};
  static constexpr Format kTexelFractionOf{"texel_fraction", false, 0, kConfig.subtexel_bits, "texel"};
  static constexpr Format kLine{"line", false, 2 * (kSizeBits - kTileLog2) + 1, 0, "memory line"};
  static constexpr Format kChannel{"channel", false, 8, kTexelFraction, "1/255"};
  static constexpr Format kFiltered{"filtered", false, 8, kTexelFraction + kFilterFraction, "1/255"};
  static constexpr Format kAccumulated{"accumulated", false, 8, kTexelFraction + kFilterFraction + kConfig.weight_bits,
                                       "1/255"};
  static constexpr Format kPixel{"pixel", false, 8, kConfig.pixel_fraction_bits, "1/255"};

  static constexpr Format kMode{"mode", false, bits_for(kModeNames.size()), 0, "code"};
  static constexpr Format kWrap{"wrap", false, bits_for(kWrapNames.size()), 0, "code"};
  static constexpr Format kTexelFormat{"texel_format", false, bits_for(kTexelFormatNames.size()), 0, "code"};

  // All of the above, for the generated package.
  static constexpr std::array kAll{
      kTag,        kFlag,         kStatus,         kFloat,         kMantissa,     kExponent,      kRadius,
      kVector,     kPosition,     kHalfStep,       kLevelOfDetail, kSampledLevel, kLevelFraction, kLevel,
      kProbeCount, kProbeIndex,   kWeightRow,      kWeight,        kTableScale,   kTableFraction, kFactor,
      kReciprocal, kLineFraction, kSizeReciprocal, kSizeShift,     kSize,         kTexelIndex,    kTexelFractionOf,
      kLine,       kChannel,      kFiltered,       kAccumulated,   kPixel,        kMode,          kWrap,
      kTexelFormat};
};

}  // namespace feline
