// SPDX-License-Identifier: Apache-2.0
// plan: radii to probe count, level of detail, step vector and weight row.
//
// Takes  major_u, major_v S8.8, major_radius, minor_radius U8.7, texel * 2^exponent, as footprint makes them: minor
//        <= major, and major is 0 or at least 64; the sampler state.
// Gives  probes 1 .. 16; half_step_s, half_step_t S19.24 textures, half the distance of two probes; weight_row;
//        level_of_detail U4.8, biased and clamped; linear: whether texels are interpolated, which the magnification
//        filter decides where the biased and clamped level is 0, however many probes there are.
// Rounds length and blur factors, the widened radius: nearest, ties up. Division by a count: product with the nearest
//        16-bit reciprocal (reciprocal ROM). The radius whose log2 is taken: nearest, ties up, to 9 significant bits;
//        log2 of it: to nearest. (major - minor) over the major radius before lengthFactor: down to 12 bits; that over
//        probes - 1: nearest, ties up, to 16 bits. ext: half of 1/(probes + 1), nearest, ties up, to 16 bits. Half
//        step: nearest, ties away from zero, once.
// Edges  A radius below one texel is one texel; when the major one is, too, there is one probe, and the level of detail
//        is that of the major radius, below 0, as a bias needs it. ext just above one texel takes two probes, each at
//        level 0. A footprint wider than the 1 x 1 level takes one probe. Level of detail before the bias saturates at
//        -32 and 31.996. minor_radius 0 means max_probes. Unsupported: more probes than the configuration has, though
//        the application grants them; a level, a fraction of a level or a kind of texels that it lacks.
//        Where it has no wrap mode that clamps, half steps are modulo 4.
// Source WRL 99/1, 3.1, 3.2, 3.4; EXT_texture_filter_anisotropic (ext); Vulkan 1.3, 16.8 (bias, clamp, magnification).
//        Weight row: fProbes in quarters (a row stands for its middle, a whole row for itself), kept within the four
//        rows of its probe count. The printed rule, the smaller of fProbes and iProbes, meets the row of one probe less
//        when 3.4's ceiling rounds up by more than 3/4.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "model/features.h"
#include "tables/roms.h"
#include "tables/rounding.h"
#include "tables/sampler_state.h"

namespace feline {

// The radii after clamping to one texel and shortening.
struct ClampedRadii {
  bool magnified;
  std::int64_t major;
  std::int64_t minor;
};

template <Config kConfig>
ClampedRadii clamp_radii(const FootprintBeat<kConfig>& footprint, Mode mode, std::int64_t length_factor) {
  using F = Formats<kConfig>;
  const std::int64_t major = footprint.major_radius.raw();
  // One texel in units of the radius' last bit; 0 when it is less than that.
  const std::int64_t one_log2 = F::kRadius.fraction_bits - footprint.exponent.raw();
  const std::int64_t one = one_log2 < 0 ? 0 : std::int64_t{1} << std::min<std::int64_t>(one_log2, F::kRadius.width());
  if (major < one || major == 0) return {true, major, major};
  const std::int64_t minor = std::max(footprint.minor_radius.raw(), one);
  if (mode == Mode::kExt) return {false, major, minor};
  return {false, std::max(round_up_ties(major * length_factor, F::kFactor.fraction_bits), minor), minor};
}

// The quotient of the radii in eighths, which probe count and weight row follow from; the minor radius is not 0.
constexpr std::int64_t eighths_of(const ClampedRadii& radii) { return 8 * radii.major / radii.minor; }

// How many probes a footprint wants, before any limit. It is not magnified, and its minor radius is not 0.
template <Config kConfig>
std::int64_t wanted_probes(const ClampedRadii& radii, Mode mode, const SamplerState<kConfig>& sampler) {
  if (mode == Mode::kExt) return (radii.major + radii.minor - 1) / radii.minor;
  if (rounds_up<kConfig>(sampler)) {
    // ceiling(2 f major/minor) - 1 is the number of multiples of minor below 2 f major.
    return (2 * sampler.probe_factor.raw() * radii.major - 1) /
           (radii.minor << Formats<kConfig>::kFactor.fraction_bits);
  }
  // floor(fProbes + 1/2) with fProbes = 2 major/minor - 1.
  return (eighths_of(radii) - 2) / 4;
}

struct ProbeChoice {
  std::int64_t probes;
  bool limited;  // more were wanted than max_probes
};

template <Config kConfig>
ProbeChoice choose_probes(const ClampedRadii& radii, Mode mode, const SamplerState<kConfig>& sampler) {
  if (radii.magnified) return {1, false};
  const std::int64_t most = sampler.max_probes.raw();
  if (radii.minor == 0) return {most, true};
  const std::int64_t wanted = wanted_probes<kConfig>(radii, mode, sampler);
  return {std::clamp<std::int64_t>(wanted, 1, most), wanted > most};
}

// The row of the weight table; fProbes in quarters is floor(8 major/minor) - 4.
template <Config kConfig>
std::int64_t choose_weight_row(const ClampedRadii& radii, Mode mode, std::int64_t probes) {
  if (mode == Mode::kExt) return Formats<kConfig>::kGaussianRows + probes - 1;
  if (probes == 1) return 0;
  const std::int64_t quarters = radii.minor == 0 ? 4 * probes : eighths_of(radii) - 4;
  return std::clamp(quarters, 4 * probes - 3, 4 * probes) - 4;
}

// The minor radius that fits the probe count, which sets the level of detail.
template <Config kConfig>
std::int64_t fit_minor_radius(const ClampedRadii& radii, Mode mode, const ProbeChoice& choice,
                              const SamplerState<kConfig>& sampler) {
  using F = Formats<kConfig>;
  constexpr int kReciprocalFraction = F::kReciprocal.fraction_bits;
  constexpr int kFactorFraction = F::kFactor.fraction_bits;
  const auto reciprocal = [](std::int64_t k) {
    return static_cast<std::int64_t>(roms<kConfig>().reciprocal.words[static_cast<std::size_t>(k)]);
  };
  if (radii.magnified) return radii.major;
  if (mode == Mode::kExt) return round_up_ties(radii.major * reciprocal(choice.probes), kReciprocalFraction);
  const std::int64_t widened = round_up_ties(2 * radii.major * reciprocal(choice.probes + 1), kReciprocalFraction);
  if (!rounds_up<kConfig>(sampler)) return std::max(radii.minor, widened);
  if (choice.limited) return round_up_ties(widened * sampler.inverse_alias_factor.raw(), kFactorFraction);
  return std::min(widened, round_up_ties(radii.minor * sampler.blur_factor.raw(), kFactorFraction));
}

// log2(radius * 2^exponent) in texels, saturated.
template <Config kConfig>
Fixed<Formats<kConfig>::kLevelOfDetail> level_of_radius(std::int64_t radius, std::int64_t exponent) {
  using F = Formats<kConfig>;
  using LevelOfDetail = Fixed<F::kLevelOfDetail>;
  constexpr int kFraction = kConfig.level_fraction_bits;
  if (radius == 0) return LevelOfDetail::from_raw(F::kLevelOfDetail.min_raw());
  std::int64_t top = bit_length(radius) - 1;
  std::int64_t normalized =
      top > kFraction ? round_up_ties(radius, static_cast<int>(top) - kFraction) : radius << (kFraction - top);
  if (normalized >> (kFraction + 1) != 0) {
    normalized >>= 1;
    ++top;
  }
  const std::int64_t fraction = static_cast<std::int64_t>(
      roms<kConfig>().log2.words[static_cast<std::size_t>(normalized & ((std::int64_t{1} << kFraction) - 1))]);
  return LevelOfDetail::saturate(((exponent + top - F::kRadius.fraction_bits) << kFraction) + fraction);
}

// The part of the major vector, U1.12, that the line from -(major - fitted) to +(major - fitted) spans.
template <Config kConfig>
std::int64_t line_fraction(std::int64_t major, std::int64_t fitted, std::int64_t major_radius) {
  return ((major - fitted) << Formats<kConfig>::kLineFraction.fraction_bits) / major_radius;
}

// How far along the major vector half a step goes: a factor U1.16 of it. `line` is of line_fraction.
template <Config kConfig>
std::int64_t half_step_factor(Mode mode, std::int64_t probes, std::int64_t line) {
  const auto reciprocal = [](std::int64_t k) {
    return static_cast<std::int64_t>(roms<kConfig>().reciprocal.words[static_cast<std::size_t>(k)]);
  };
  if (probes == 1) return 0;
  // ext: steps of 1/(N + 1) of the vector. Feline: the line from -(major - minor) to +(major - minor) in N - 1 steps.
  if (mode == Mode::kExt) return round_up_ties(reciprocal(probes + 1), 1);
  return round_up_ties(line * reciprocal(probes - 1), Formats<kConfig>::kLineFraction.fraction_bits);
}

template <Config kConfig>
Fixed<Formats<kConfig>::kHalfStep> to_half_step(std::int64_t vector, std::int64_t factor, std::int64_t size_reciprocal,
                                                std::int64_t size_shift, std::int64_t exponent) {
  using F = Formats<kConfig>;
  constexpr bool kIsModular = !kConfig.features.clamp_to_edge && !kConfig.features.clamp_to_border;
  constexpr int kProductFraction =
      F::kVector.fraction_bits + F::kReciprocal.fraction_bits + F::kSizeReciprocal.fraction_bits;
  const std::int64_t right = kProductFraction - F::kPositionFraction + size_shift - exponent;
  const std::int64_t product = vector * factor * size_reciprocal;
  // A length_factor below 1/8 on a texture one texel wide can ask for more bits instead of fewer.
  const std::int64_t half_step =
      right < 0 ? product * (std::int64_t{1} << -right) : round_away_ties(product, static_cast<int>(right));
  if constexpr (kIsModular) {
    constexpr int kSpare = 64 - F::kHalfStep.width();
    return Fixed<F::kHalfStep>::from_raw(static_cast<std::int64_t>(static_cast<std::uint64_t>(half_step) << kSpare) >>
                                         kSpare);
  } else {
    return Fixed<F::kHalfStep>::from_raw(half_step);
  }
}

// The level of detail that is sampled, from the one before its bias: clamped, and in the modes of one level rounded.
struct LevelChoice {
  std::int64_t level_of_detail;
  bool linear;   // texels are interpolated
  bool missing;  // either is not what it should be, as the configuration lacks it
};

template <Config kConfig>
LevelChoice choose_level(std::int64_t base_level, Mode mode, const SamplerState<kConfig>& sampler) {
  constexpr Features kFeatures = kConfig.features;
  constexpr int kFraction = kConfig.level_fraction_bits;
  const std::int64_t lambda =
      std::clamp(base_level + sampler.level_bias.raw(), sampler.min_level.raw(), sampler.max_level.raw());
  const bool magnifies = lambda == 0;
  const bool nearest_level = mode == Mode::kNearest || mode == Mode::kBilinear;
  // The nearest level, ties to the finer one, as OpenGL and Vulkan prefer.
  constexpr std::int64_t kBelowHalf = (std::int64_t{1} << (kFraction - 1)) - 1;
  const std::int64_t level = nearest_level ? ((lambda + kBelowHalf) >> kFraction) << kFraction : lambda;
  const std::int64_t last = sampler.last_level.raw() << kFraction;
  constexpr std::int64_t kWhole = ~((std::int64_t{1} << kFraction) - 1);
  const std::int64_t sampled = std::min(level, last);
  const std::int64_t level_of_detail = kFeatures.level_blend ? sampled : sampled & kWhole;
  const bool linear_magnify = static_cast<Magnify>(sampler.magnify.raw()) == Magnify::kLinear;
  const bool asked_linear = magnifies ? linear_magnify : mode != Mode::kNearest;
  const bool linear = (asked_linear && kFeatures.linear_texels) || !kFeatures.nearest_texels;
  const bool cut = level > last && sampler.levels_cut.raw() != 0;
  return {level_of_detail, linear, cut || sampled != level_of_detail || asked_linear != linear};
}

// Where `skips_point`, the line of a single probe is not set up: its half steps are 0 without it, too.
template <Config kConfig>
PlanBeat<kConfig> plan(const FootprintBeat<kConfig>& footprint, const SamplerState<kConfig>& sampler,
                       bool skips_point = false) {
  PlanBeat<kConfig> beat;
  beat.tag = footprint.tag;
  beat.s = footprint.s;
  beat.t = footprint.t;
  constexpr int kFraction = kConfig.level_fraction_bits;
  const Mode mode = supported_mode<kConfig>(sampler);
  const std::int64_t exponent = footprint.exponent.raw();

  const ClampedRadii radii = clamp_radii<kConfig>(footprint, mode, supported_length_factor<kConfig>(sampler));
  const ProbeChoice choice = choose_probes<kConfig>(radii, mode, sampler);
  const std::int64_t fitted = fit_minor_radius<kConfig>(radii, mode, choice, sampler);
  const std::int64_t base_level = level_of_radius<kConfig>(fitted, exponent).raw();
  const bool beyond_smallest = base_level > (sampler.smallest_level.raw() << kFraction);
  const std::int64_t probes = beyond_smallest ? 1 : choice.probes;

  if (probes > 1 || !skips_point) {
    const bool has_line = probes > 1 && mode != Mode::kExt;
    const std::int64_t line = has_line ? line_fraction<kConfig>(radii.major, fitted, footprint.major_radius.raw()) : 0;
    const std::int64_t factor = half_step_factor<kConfig>(mode, probes, line);
    beat.half_step_s = to_half_step<kConfig>(footprint.major_u.raw(), factor, sampler.width_reciprocal.raw(),
                                             sampler.width_shift.raw(), exponent);
    beat.half_step_t = to_half_step<kConfig>(footprint.major_v.raw(), factor, sampler.height_reciprocal.raw(),
                                             sampler.height_shift.raw(), exponent);
  }
  beat.probes = beat.probes.from_raw(probes);
  beat.weight_row = beat.weight_row.from_raw(choose_weight_row<kConfig>(radii, mode, probes));
  const LevelChoice level = choose_level<kConfig>(base_level, mode, sampler);
  beat.level_of_detail = beat.level_of_detail.from_raw(level.level_of_detail);
  beat.linear = beat.linear.from_raw(level.linear);
  const bool missing = (choice.limited && sampler.probes_cut.raw() != 0) || level.missing;
  beat.status = beat.status.from_raw(footprint.status.raw() | unsupported_if(missing));
  return beat;
}

}  // namespace feline
