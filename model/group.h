// SPDX-License-Identifier: Apache-2.0
// group: float32 coordinates to fixed point, float32 derivatives to four mantissas under one exponent.
//
// Takes  s, t and the derivatives ds/dx, dt/dx, ds/dy, dt/dy, float32, normalized (1 = the texture's size).
// Gives  s, t S20.24 textures; dudx, dvdx, dudy, dvdy S7.0 in texels of level 0 * 2^exponent; exponent S6.0.
// Rounds s, t: nearest, ties away from zero. Mantissas: simple and table nearest, ties away from zero; the other modes
//        outward (away from zero), so that a growing footprint never shrinks. The exponent is the least with which no
//        rounded magnitude exceeds 127; the largest is then 64 .. 127.
// Edges  Denormals are 0. |s| or |t| >= 2^19: the clamps saturate at 2^19, the repeats keep the value modulo 2^21.
//        NaN coordinates are 0; infinite ones are +-2^19 (clamps) or 0 (repeats). A NaN or infinite derivative gives
//        the unbounded footprint (127, 0), (0, 127), exponent 63. exponent > 63 saturates; exponent < -64 gives zeros
//        at -64. -128 never occurs: negating a gradient negates its mantissas. Status: coordinate or derivative not
//        finite; overflow where a clamp saturates a finite coordinate or exponent > 63 saturates; unsupported where the
//        configuration's exponent is narrower than that and saturates, or a coordinate saturates nearer than 2^19, or
//        it has no place for a derivative that is not 0.
// Source McCormack et al., WRL 99/1, 3.2 (group scaling); CS248A lecture 4, steps 2 and 4.
#pragma once

#include <algorithm>
#include <array>

#include "model/features.h"
#include "tables/rounding.h"
#include "tables/sampler_state.h"

namespace feline {

struct FloatParts {
  bool negative = false;
  int exponent = 0;           // biased
  std::int64_t fraction = 0;  // 23 bits
  bool finite() const { return exponent != 255; }
  bool normal() const { return exponent != 0 && finite(); }
  std::int64_t significand() const { return (std::int64_t{1} << 23) | fraction; }
};

constexpr FloatParts float_parts(std::int64_t bits) {
  return {(bits >> 31) != 0, static_cast<int>((bits >> 23) & 255), bits & 0x7fffff};
}

// Whether a wrap mode clamps a coordinate at 2^range_log2 or farther, if it is a number.
constexpr bool reaches(const FloatParts& parts, Wrap wrap, int range_log2) {
  const bool clamps = wrap == Wrap::kClampToEdge || wrap == Wrap::kClampToBorder;
  return clamps && parts.exponent >= 127 + range_log2;
}

template <Config kConfig>
Fixed<Formats<kConfig>::kPosition> to_position(const FloatParts& parts, Wrap wrap) {
  using F = Formats<kConfig>;
  using Position = Fixed<F::kPosition>;
  const bool is_nan = !parts.finite() && parts.fraction != 0;
  if (parts.exponent == 0 || is_nan) return Position{};
  constexpr std::int64_t kLimit = std::int64_t{1} << (F::kSaturationLog2 + F::kPositionFraction);
  if (reaches(parts, wrap, F::kSaturationLog2)) return Position::from_raw(parts.negative ? -kLimit : kLimit);
  if (!parts.finite()) return Position{};
  // The significand's unit is 2^(exponent - 150).
  const int left = parts.exponent - 150 + F::kPositionFraction;
  constexpr int kWidth = F::kPosition.width();
  std::uint64_t magnitude = 0;
  if (left < 0) {
    magnitude = static_cast<std::uint64_t>(round_away_ties(parts.significand(), -left));
  } else if (left < kWidth) {
    magnitude = static_cast<std::uint64_t>(parts.significand()) << left;
  }
  // Modulo 2^kWidth, as a two's complement number: the repeats need no more.
  const std::uint64_t wrapped = (parts.negative ? 0 - magnitude : magnitude) << (64 - kWidth);
  return Position::from_raw(static_cast<std::int64_t>(wrapped) >> (64 - kWidth));
}

template <Config kConfig>
GroupBeat<kConfig> group(const RequestBeat<kConfig>& request, const SamplerState<kConfig>& sampler) {
  using F = Formats<kConfig>;
  using Mantissa = Fixed<F::kMantissa>;
  GroupBeat<kConfig> beat;
  beat.tag = request.tag;
  const FloatParts s = float_parts(request.s.raw());
  const FloatParts t = float_parts(request.t.raw());
  const Wrap wrap_s = supported_wrap<kConfig>(sampler.wrap_s);
  const Wrap wrap_t = supported_wrap<kConfig>(sampler.wrap_t);
  beat.s = to_position<kConfig>(s, wrap_s);
  beat.t = to_position<kConfig>(t, wrap_t);

  std::array<FloatParts, 4> parts{float_parts(request.dsdx.raw()), float_parts(request.dtdx.raw()),
                                  float_parts(request.dsdy.raw()), float_parts(request.dtdy.raw())};
  constexpr Features kFeatures = kConfig.features;
  constexpr std::array kPlaces{kFeatures.dudx, kFeatures.dvdx, kFeatures.dudy, kFeatures.dvdy};
  const bool finite = std::ranges::all_of(parts, [](const FloatParts& p) { return p.finite(); });
  constexpr int kFullRange = std::max(F::kSaturationLog2, kFullRangeLog2);
  const auto saturates_early = [](const FloatParts& parts, Wrap wrap) {
    return reaches(parts, wrap, F::kSaturationLog2) && !reaches(parts, wrap, kFullRange);
  };
  const bool overflows =
      (s.finite() && reaches(s, wrap_s, kFullRange)) || (t.finite() && reaches(t, wrap_t, kFullRange));
  bool missing = false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (kPlaces[i]) continue;
    missing = missing || parts[i].exponent != 0;
    parts[i] = {};
  }
  const auto raise = [&](std::int64_t status) { beat.status = beat.status.from_raw(beat.status.raw() | status); };
  raise((s.finite() && t.finite() ? 0 : kCoordinateNotFinite) | (finite ? 0 : kDerivativeNotFinite) |
        (overflows ? kOverflow : 0) |
        unsupported_if(missing || saturates_early(s, wrap_s) || saturates_early(t, wrap_t)));

  constexpr std::int64_t kMax = F::kMantissa.max_raw();
  // A configuration may have a narrower exponent, outside which a lookup is unsupported.
  constexpr std::int64_t kFullMax = (std::int64_t{1} << kFullExponentBits) - 1;
  constexpr bool kIsNarrow = F::kExponent.max_raw() < kFullMax;
  if (!finite) {
    raise(unsupported_if(kIsNarrow || !kFeatures.dudx || !kFeatures.dvdy));
    beat.exponent = beat.exponent.from_raw(F::kExponent.max_raw());
    if (kFeatures.dudx) beat.dudx = Mantissa::from_raw(kMax);
    if (kFeatures.dvdy) beat.dvdy = Mantissa::from_raw(kMax);
    return beat;
  }

  // Texels of level 0: product * 2^(exponent - 150), the product below 2^(24 + 15).
  std::array<std::int64_t, 4> product{};
  int top = -1000;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t size = (i % 2 == 0 ? sampler.width : sampler.height).raw();
    if (!parts[i].normal()) continue;
    product[i] = parts[i].significand() * size;
    top = std::max(top, parts[i].exponent - 150 + bit_length(product[i]) - 1);
  }
  int exponent = top - (F::kMagnitudeBits - 1);
  const Mode mode = supported_mode<kConfig>(sampler);
  const bool nearest = mode == Mode::kSimple || mode == Mode::kTable;
  std::array<std::int64_t, 4> magnitude{};
  const auto round_all = [&] {
    for (std::size_t i = 0; i < 4; ++i) {
      const int bits = exponent - (parts[i].exponent - 150);
      if (product[i] != 0) magnitude[i] = nearest ? round_away_ties(product[i], bits) : round_outward(product[i], bits);
    }
  };
  round_all();
  if (std::ranges::any_of(magnitude, [](std::int64_t m) { return m > kMax; })) {
    ++exponent;
    round_all();
  }
  if (exponent < F::kExponent.min_raw()) {
    raise(unsupported_if(kIsNarrow && exponent >= ~kFullMax));
    beat.exponent = beat.exponent.from_raw(F::kExponent.min_raw());
    return beat;
  }
  if (exponent > kFullMax) raise(kOverflow);
  raise(unsupported_if(kIsNarrow && exponent > F::kExponent.max_raw()));
  beat.exponent = beat.exponent.saturate(exponent);
  const auto mantissa = [&](std::size_t i) {
    return Mantissa::from_raw(parts[i].negative ? -magnitude[i] : magnitude[i]);
  };
  beat.dudx = mantissa(0);
  beat.dvdx = mantissa(1);
  beat.dudy = mantissa(2);
  beat.dvdy = mantissa(3);
  return beat;
}

}  // namespace feline
