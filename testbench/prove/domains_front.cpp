// SPDX-License-Identifier: Apache-2.0
// Over which inputs each leaf is enumerated.
#include <cmath>

#include "model/sampler.h"
#include "testbench/prove/domains.h"
#include "testbench/prove/errors.h"
#include "testbench/prove/leaves.h"
#include "testbench/random.h"

namespace feline::prove {
namespace {

using F = UnitFormats;

std::int64_t factor(double value) { return std::llround(value * static_cast<double>(F::kFactor.one())); }

// How Feline 3.4's parameters and EXT come to a unit: each named set once.
struct ParameterSet {
  Mode mode;
  std::int64_t rounding, length, blur, inverse_alias, probe;
};
ParameterSet parameter_set(Mode mode, const ProbeParameters& parameters) {
  return {mode,
          code(parameters.rounding),
          factor(parameters.length_factor),
          factor(parameters.blur_factor),
          factor(1 / parameters.alias_factor),
          factor(1 / (parameters.blur_factor * parameters.alias_factor))};
}
std::vector<ParameterSet> parameter_sets() {
  return {parameter_set(Mode::kExt, kExact), parameter_set(Mode::kTable, kExact),
          parameter_set(Mode::kTable, kHighQuality), parameter_set(Mode::kTable, kHighEfficiency)};
}

// The modes that plan takes as it takes table: fewer major radii show that it does.
constexpr std::int64_t kStride = 257;
std::vector<ParameterSet> parameter_sets_of_like_modes() {
  std::vector<ParameterSet> sets;
  for (const Mode mode : {Mode::kNearest, Mode::kBilinear, Mode::kTrilinear, Mode::kSimple}) {
    for (const ProbeParameters& parameters : {kExact, kHighQuality, kHighEfficiency}) {
      sets.push_back(parameter_set(mode, parameters));
    }
  }
  return sets;
}

// A footprint's major radius is 0 or at least this: its largest mantissa is at least 64 and both of its factors are one
// or more. Shortened, it may be a little less.
constexpr std::int64_t kLeastMajor = std::int64_t{1} << (F::kMagnitudeBits - 1 + FormatSet::kLengthFraction);
std::int64_t least_shortened(const ParameterSet& set) { return kLeastMajor * set.length / F::kFactor.one(); }
constexpr std::int64_t kMostMajor = F::kRadius.max_raw();

// Every stride-th major radius from `least` on, the last field first_of(major) up to most_of(major).
template <typename L>
Domain radius_rows(std::int64_t least, std::int64_t stride, const std::function<std::int64_t(std::int64_t)>& most_of,
                   std::function<Values<L::kInputs>(std::int64_t)> first_of) {
  const auto major_of = [=](std::uint64_t row) { return least + static_cast<std::int64_t>(row) * stride; };
  return rows<L>(
      "", static_cast<std::uint64_t>((kMostMajor - least) / stride) + 1,
      [=](std::uint64_t row) { return static_cast<std::uint64_t>(most_of(major_of(row))) + 1; },
      [major_of, first_of = std::move(first_of)](std::uint64_t row) { return first_of(major_of(row)); });
}

// Every stride-th major radius with every minor one that is not larger, the other fields as `head` has them.
template <typename L>
Domain radius_pairs(const std::vector<std::int64_t>& head, std::int64_t least_major, std::int64_t stride = 1) {
  return radius_rows<L>(
      least_major, stride, [](std::int64_t major) { return major; },
      [=](std::int64_t major) {
        Values<L::kInputs> values{};
        std::ranges::copy(head, values.begin());
        values[head.size()] = major;
        return values;
      });
}

Domain positions() {
  return product<Position>("every float32, every wrap mode", {Axis::all(F::kWrap), Axis::all(F::kFloat)});
}

// Two of the four matter at once: the largest, which sets the exponent, and one that is aligned to it.
Domain aligned_derivatives() {
  constexpr std::uint64_t kTails = 3;
  constexpr std::array<std::int64_t, 25> kDistances{0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10,  11, 12,
                                                    13, 14, 15, 16, 17, 31, 39, 40, 63, 64, 127, 200};
  constexpr std::array<std::int64_t, 3> kSizes{1, 1000, 16384};
  const auto significand = [](std::int64_t top, int top_bits, std::int64_t tail) {
    const int left = 23 - top_bits;
    const std::int64_t ones = (std::int64_t{1} << left) - 1;
    return (top << left) | (tail == 0 ? 0 : tail == 1 ? 1 : ones);
  };
  const Domain lattice =
      mapped<Align>("", 2 * 4 * 256 * kTails * kDistances.size() * 512 * kTails * kSizes.size(), [=](std::uint64_t i) {
        Digits digits(i);
        const std::int64_t lead = digits.take(4);
        const std::int64_t lead_tail = digits.take(kTails);
        const std::int64_t tail = digits.take(kTails);
        const std::int64_t distance = kDistances[static_cast<std::size_t>(digits.take(kDistances.size()))];
        const std::int64_t size = kSizes[static_cast<std::size_t>(digits.take(kSizes.size()))];
        const std::int64_t mode = digits.take(2) == 0 ? code(Mode::kTrilinear) : code(Mode::kTable);
        const std::int64_t top = digits.take(512);
        const std::int64_t lead_top = digits.take(256);
        // Lane of the other one, signs and exponent by chance.
        SplitMix64 draw(i);
        const std::int64_t exponent = distance > 50 ? 254 : 60 + static_cast<std::int64_t>(draw.below(131));
        const auto sign = [&] { return static_cast<std::int64_t>(draw.below(2)) << 31; };
        std::array<std::int64_t, 4> derivative{};
        derivative[static_cast<std::size_t>(lead)] = sign() | (exponent << 23) | significand(lead_top, 8, lead_tail);
        derivative[(static_cast<std::size_t>(lead) + 1 + draw.below(3)) % 4] =
            sign() | ((exponent - distance) << 23) | significand(top, 9, tail);
        return Align::Inputs{mode, size, size, derivative[0], derivative[1], derivative[2], derivative[3]};
      });
  const Domain random = mapped<Align>("", std::uint64_t{1} << 26, [](std::uint64_t i) {
    SplitMix64 draw(i);
    Align::Inputs inputs{static_cast<std::int64_t>(draw.below(6)), 1 + draw.below(16384), 1 + draw.below(16384)};
    // Every class of float32, and exponents near to each other.
    const auto centre = static_cast<std::int64_t>(draw.below(256));
    for (std::size_t k = 3; k < inputs.size(); ++k) {
      const std::int64_t exponent = draw.chance(0.1) ? draw.below(256) : centre + draw.below(20) - 10;
      inputs[k] = static_cast<std::int64_t>(draw.below(2)) << 31 | std::clamp<std::int64_t>(exponent, 0, 255) << 23 |
                  static_cast<std::int64_t>(draw.chance(0.2) ? 0 : draw.below(1 << 23));
    }
    return inputs;
  });
  return joined(
      "lattice: of the largest derivative every 8 leading bits, of another one every 9 at 25 distances, "
      "with zeros, ones and a lowest bit behind, of three sizes; 2^26 random combinations of every "
      "float32 class",
      lane_words<Align::kInputs>(), {lattice, random});
}

Domain footprints(Mode mode) {
  const Axis mantissa = Axis::range(-F::kMantissa.max_raw(), F::kMantissa.max_raw());
  return product<Footprint>("every combination of four mantissas that group makes, -127 to 127",
                            {code(mode), mantissa, mantissa, mantissa, mantissa});
}

// Exponents at which a texel is more than any radius, or less than its last bit, are all alike.
Domain clamped_radii() {
  std::vector<Domain> parts;
  // Both ceilings shorten alike.
  const auto shortens_again = [](const ParameterSet& set) { return set.blur == factor(kHighEfficiency.blur_factor); };
  const auto append_pairs = [&](const ParameterSet& set, std::int64_t stride) {
    const int least = F::kRadius.fraction_bits - F::kRadius.width() + 1;
    for (std::int64_t exponent = least; exponent <= F::kRadius.fraction_bits + 1; ++exponent) {
      parts.push_back(radius_pairs<ClampRadii>({code(set.mode), set.length, exponent}, kLeastMajor, stride));
    }
  };
  for (const ParameterSet& set : parameter_sets_of_like_modes()) {
    if (!shortens_again(set)) append_pairs(set, kStride);
  }
  for (const ParameterSet& set : parameter_sets()) {
    if (shortens_again(set)) continue;
    append_pairs(set, 1);
    parts.push_back(product<ClampRadii>(
        "", {code(set.mode), set.length, Axis::all(F::kExponent), Axis::range(kLeastMajor, kMostMajor),
             Axis({0, 1, 127, 128, 8191, 8192, 16384, 20000})}));
    parts.push_back(product<ClampRadii>("", {code(set.mode), set.length, Axis::all(F::kExponent), 0, 0}));
  }
  return joined(
      "every pair of radii, major 0 or at least 64 texels and minor not larger, at each exponent at which a texel is "
      "within the radii's range; every major radius with eight minor ones at every exponent; length factors of the "
      "named parameter sets, modes table and ext; in the other modes each 257th major radius",
      lane_words<ClampRadii::kInputs>(), std::move(parts));
}

Domain radii_that_want_probes() {
  std::vector<Domain> parts;
  const auto append = [&](const ParameterSet& set, std::int64_t stride) {
    parts.push_back(
        radius_pairs<WantedProbes>({code(set.mode), set.rounding, set.probe}, least_shortened(set), stride));
  };
  for (const ParameterSet& set : parameter_sets_of_like_modes()) append(set, kStride);
  for (const ParameterSet& set : parameter_sets()) append(set, 1);
  return joined(
      "every pair of radii, the major one from a shortened 64 texels on, minor not larger; named "
      "parameter sets, modes table and ext; in the other modes each 257th major radius",
      lane_words<WantedProbes::kInputs>(), std::move(parts));
}

Domain probe_limits() {
  return product<ChooseProbes>("every wanted count, every maxProbes",
                               {Axis::range(0, 1), Axis::range(1, kUnit.max_probes), Axis::all(WantedProbes::kWanted)});
}

// Of a pair of radii every probe count up to the finest rule's, 2 major/minor + 1.
Domain fitted_radii() {
  std::vector<Domain> parts;
  const auto append = [&](const ParameterSet& set, std::int64_t limited, std::int64_t probes, std::int64_t stride) {
    parts.push_back(radius_rows<FitRadius>(
        least_shortened(set), stride,
        [=](std::int64_t major) { return probes == 1 ? major : std::min(major, 2 * major / (probes - 1)); },
        [=](std::int64_t major) {
          return FitRadius::Inputs{code(set.mode), set.rounding, set.blur, set.inverse_alias, limited, probes, major};
        }));
  };
  const auto append_all = [&](const ParameterSet& set, std::int64_t stride) {
    for (const std::int64_t limited : {0, 1}) {
      if (limited == 1 && set.rounding == 0) continue;
      for (std::int64_t probes = 1; probes <= kUnit.max_probes; ++probes) append(set, limited, probes, stride);
    }
  };
  for (const ParameterSet& set : parameter_sets_of_like_modes()) append_all(set, kStride);
  for (const ParameterSet& set : parameter_sets()) append_all(set, 1);
  // Radii of nothing, and what only the ceiling looks at, for the others.
  for (const ParameterSet& set : parameter_sets()) {
    parts.push_back(product<FitRadius>(
        "", {code(set.mode), set.rounding, set.blur, set.inverse_alias, Axis::range(0, 1),
             Axis::range(1, kUnit.max_probes), Axis::range(0, kMostMajor), Axis({0, 1, 127, 128, 8192})}));
  }
  return joined(
      "every pair of radii from a shortened 64 texels on with every probe count up to 2 major/minor + "
      "1, so that they can come to it by some maxProbes; named parameter sets, modes table and ext, the "
      "ceilings limited and not; every major radius with five minor ones, limited and not; in the other modes each "
      "257th major radius",
      lane_words<FitRadius::kInputs>(), std::move(parts));
}

Domain line_fractions() {
  const Domain whole = rows<LineFraction>(
      "", static_cast<std::uint64_t>(kMostMajor) + 1,
      [](std::uint64_t rest) {
        return static_cast<std::uint64_t>(kMostMajor - std::max(static_cast<std::int64_t>(rest), kLeastMajor)) + 1;
      },
      [](std::uint64_t rest) {
        const auto major = static_cast<std::int64_t>(rest);
        return LineFraction::Inputs{0, major, std::max(major, kLeastMajor)};
      });
  const Domain fitted = mapped<LineFraction>("", std::uint64_t{1} << 24, [](std::uint64_t i) {
    SplitMix64 draw(i);
    const auto below = [&](std::int64_t count) {
      return static_cast<std::int64_t>(draw.below(static_cast<std::uint32_t>(count)));
    };
    const std::int64_t major_radius = kLeastMajor + below(kMostMajor - kLeastMajor + 1);
    const std::int64_t major = below(major_radius + 1);
    return LineFraction::Inputs{below(major + 1), major, major_radius};
  });
  return joined(
      "every difference up to every major radius of at least 64 texels, from a fitted radius of 0; 2^24 "
      "random radii, the fitted one any",
      lane_words<LineFraction::kInputs>(), {whole, fitted});
}

Domain sampled_levels() {
  const Axis modes({code(Mode::kNearest), code(Mode::kBilinear), code(Mode::kTrilinear)});
  const std::int64_t most = F::kSampledLevel.max_raw();
  const Axis flag = Axis::range(0, 1);
  const Axis level = Axis::all(F::kLevelOfDetail);
  std::vector<Domain> parts{product<SampledLevel>("", {modes, flag, 0, F::kLevels - 1, 0, most, level, level})};
  const std::vector<std::int64_t> limits{0, 1, 128, 129, 255, 256, 2048, most};
  for (const std::int64_t least : limits) {
    for (const std::int64_t greatest : limits) {
      if (least > greatest) continue;
      parts.push_back(product<SampledLevel>("", {Axis::range(0, 5), flag, flag, Axis::range(0, F::kLevels - 1), least,
                                                 greatest, Axis({-4096, -128, 0, 1, 4095}), level}));
    }
  }
  return joined(
      "every level with every bias in three modes; every level with corners of biases and limits, every "
      "last level and mode",
      lane_words<SampledLevel::kInputs>(), std::move(parts));
}

Domain half_step_factors() {
  const Axis line = Axis::range(0, F::kLineFraction.one());
  std::vector<Domain> parts{
      product<HalfStepFactor>("", {Axis({code(Mode::kExt), code(Mode::kSimple), code(Mode::kTable)}),
                                   Axis::range(1, kUnit.max_probes), line}),
      product<HalfStepFactor>("", {Axis::range(0, 5), 1, Axis::all(F::kLineFraction)})};
  return joined("every probe count, line and mode; of one probe also what is no line",
                lane_words<HalfStepFactor::kInputs>(), std::move(parts));
}

Domain texture_products() {
  const std::int64_t one = F::kSizeReciprocal.one();
  return product<TextureProduct>("every vector with every reciprocal from 1 to 2, which those of all sizes are among",
                                 {Axis::range(one, 2 * one - 1), Axis::all(F::kVector)});
}

// Products and factors of every length in bits, with exponents for which the half step fits.
Domain half_steps() {
  constexpr int kTextureBits =
      F::kVector.fraction_bits + F::kReciprocal.fraction_bits + F::kSizeReciprocal.fraction_bits;
  return mapped<HalfStep>(
      "2^28 combinations, random in bits, lengths and exponents", std::uint64_t{1} << 28, [](std::uint64_t i) {
        SplitMix64 draw(i);
        const int product_bits = static_cast<int>(draw.below(TextureProduct::kProduct.width()));
        const int factor_bits = static_cast<int>(draw.below(F::kReciprocal.width()));
        const auto bits_of = [&](int bits) {
          // All ones, a single one, or anything.
          const std::int64_t ones = (std::int64_t{1} << bits) - 1;
          const std::uint32_t kind = draw.below(4);
          if (bits == 0 || kind == 0) return ones;
          const std::int64_t high = std::int64_t{1} << (bits - 1);
          return kind == 1 ? high : high | (static_cast<std::int64_t>(draw.next() >> 1) & (high - 1));
        };
        const std::int64_t product = bits_of(product_bits);
        const std::int64_t factor = bits_of(factor_bits);
        const auto shift = static_cast<std::int64_t>(draw.below(F::kSizeBits + 1));
        const std::int64_t most = F::kHalfStep.integer_bits + kTextureBits + shift - product_bits - factor_bits - 1;
        const std::int64_t limit = std::min<std::int64_t>(most, F::kSizeBits + F::kRadius.fraction_bits);
        const std::int64_t exponent = draw.chance(0.3) ? limit : limit - draw.below(40);
        return HalfStep::Inputs{draw.chance(0.5) ? -product : product, factor, shift,
                                std::clamp(exponent, F::kExponent.min_raw(), F::kExponent.max_raw())};
      });
}

Domain weight_rows() {
  return product<WeightRow>("every probe count, quotient of radii and mode",
                            {Axis({code(Mode::kExt), code(Mode::kSimple), code(Mode::kTable)}),
                             Axis::range(1, kUnit.max_probes), Axis::range(8, WantedProbes::kEighths.max_raw())});
}

}  // namespace

void append_front_leaves(std::vector<Leaf>& leaves) {
  leaves.push_back(make_leaf<Position>("group.position", "position", positions()));
  leaves.back().complete = true;
  leaves.push_back(make_leaf<Align>("group.align", "align", aligned_derivatives()));
  for (const auto& [name, mode] : {std::pair{"footprint.simple", Mode::kSimple},
                                   {"footprint.table", Mode::kTable},
                                   {"footprint.ext", Mode::kExt},
                                   {"footprint.isotropic", Mode::kTrilinear}}) {
    leaves.push_back(make_leaf<Footprint>(name, "footprint", footprints(mode)));
    leaves.back().steady_fields = 2;  // the mode, and one mantissa
    // The isotropic modes mean no ellipse.
    if (mode == Mode::kTrilinear) continue;
    leaves.back().quantities = ellipse_quantities();
    leaves.back().measure = &measure_ellipse;
  }
  leaves.push_back(make_leaf<ClampRadii>("plan.clamp_radii", "clamp_radii", clamped_radii()));
  leaves.back().steady_fields = 3;
  leaves.push_back(make_leaf<WantedProbes>("plan.wanted_probes", "wanted_probes", radii_that_want_probes()));
  leaves.back().steady_fields = 3;
  leaves.push_back(make_leaf<ChooseProbes>("plan.choose_probes", "choose_probes", probe_limits()));
  leaves.push_back(make_leaf<FitRadius>("plan.fit_radius", "fit_radius", fitted_radii()));
  leaves.back().steady_fields = 6;
  leaves.push_back(make_leaf<LevelOfRadius>(
      "plan.level_of_radius", "level_of_radius",
      product<LevelOfRadius>("every radius at every exponent", {Axis::all(F::kExponent), Axis::all(F::kRadius)})));
  leaves.back().complete = true;
  leaves.back().quantities = level_quantities();
  leaves.back().measure = &measure_level;
  leaves.push_back(make_leaf<SampledLevel>("plan.sampled_level", "sampled_level", sampled_levels()));
  leaves.push_back(make_leaf<LineFraction>("plan.line_fraction", "line_fraction", line_fractions()));
  // It sees the difference alone, which is at most the major radius. Of a radius of 0 there is one probe, which no line
  // moves (plan.half_step_factor).
  leaves.back().complete_in = "u_line_fraction.u_quotient";
  leaves.push_back(make_leaf<HalfStepFactor>("plan.half_step_factor", "half_step_factor", half_step_factors()));
  leaves.back().complete = true;
  leaves.push_back(make_leaf<TextureProduct>("plan.texture_product", "texture_product", texture_products()));
  leaves.back().complete = true;
  leaves.back().steady_fields = 1;
  leaves.push_back(make_leaf<HalfStep>("plan.half_step", "half_step", half_steps()));
  leaves.push_back(make_leaf<WeightRow>("plan.weight_row", "weight_row", weight_rows()));
}

}  // namespace feline::prove
