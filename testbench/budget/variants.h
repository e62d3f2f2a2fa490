// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <type_traits>
#include <utility>

#include "model/unit.h"
#include "testbench/budget/variant.h"
#include "testbench/prune/needs.h"

namespace feline {

// The sampler state of another unit, field by field: all formats are the same but those of levels, of which the last
// bits are cut off. A limit above all levels stays one.
template <Config kConfig>
SamplerState<kConfig> narrowed(const SamplerState<kDefaultConfig>& sampler) {
  SamplerState<kConfig> state;
  const auto copy = []<typename From, typename To>(const From& from, To& to) {
    constexpr int kCut = From::kFormatOf.fraction_bits - To::kFormatOf.fraction_bits;
    to = To::from_raw(from.raw() >> kCut);
  };
  const auto copy_field = [&]<typename From, typename To>(const From& from, To& to) {
    if constexpr (requires { from.size(); }) {
      for (std::size_t i = 0; i < from.size(); ++i) copy(from[i], to[i]);
    } else {
      copy(from, to);
    }
  };
  constexpr auto kFrom = SamplerState<kDefaultConfig>::fields();
  constexpr auto kTo = SamplerState<kConfig>::fields();
  const auto copy_all = [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (copy_field(sampler.*std::get<kIndex>(kFrom).member, state.*std::get<kIndex>(kTo).member), ...);
  };
  copy_all(std::make_index_sequence<std::tuple_size_v<decltype(kTo)>>());
  return state;
}

// Takes every beat of a unit's lookups.
template <Config kConfig>
class UseRecorder {
 public:
  UseRecorder(const SamplerState<kConfig>& sampler, VariantUse& use) : sampler_(sampler), use_(use) {}

  void operator()(const RequestBeat<kConfig>& beat) { use_.derivatives |= needed_derivatives(beat); }
  void operator()(const GroupBeat<kConfig>& beat) {
    raise(use_.position_bits, bit_length(std::max(std::abs(beat.s.raw()), std::abs(beat.t.raw()))));
    if ((beat.dudx.raw() | beat.dvdx.raw() | beat.dudy.raw() | beat.dvdy.raw()) == 0) return;
    use_.least_exponent = std::min(use_.least_exponent, static_cast<int>(beat.exponent.raw()));
    raise(use_.greatest_exponent, beat.exponent.raw());
  }
  void operator()(const FootprintBeat<kConfig>& beat) {
    const Mode mode = supported_mode<kConfig>(sampler_);
    const ClampedRadii radii = clamp_radii<kConfig>(beat, mode, sampler_.length_factor.raw());
    raise(use_.wanted_probes, choose_probes<kConfig>(radii, mode, sampler_).probes);
  }
  void operator()(const PlanBeat<kConfig>& beat) {
    use_.probes += static_cast<std::uint64_t>(beat.probes.raw());
    use_.blends |= (beat.level_of_detail.raw() & ((1 << kConfig.level_fraction_bits) - 1)) != 0;
    (beat.linear.raw() != 0 ? use_.linear : use_.nearest) = true;
  }
  void operator()(const AddressBeat<kConfig>& beat) {
    raise(use_.coarsest_level, beat.level.raw() + (beat.coarse_used.raw() != 0 ? 1 : 0));
  }
  void operator()(const FetchBeat<kConfig>& beat) { use_.translucent |= reads_translucent(beat); }
  template <typename Beat>
  void operator()(const Beat&) {}

 private:
  static void raise(int& greatest, std::int64_t value) { greatest = std::max(greatest, static_cast<int>(value)); }

  const SamplerState<kConfig>& sampler_;
  VariantUse& use_;
};

template <Config kConfig>
void sample_variant(const SamplerState<kDefaultConfig>& full_sampler, const TextureMemory& memory,
                    std::span<const Lookup> lookups, std::span<std::array<float, 4>> colours, VariantUse& use) {
  const SamplerState<kConfig> sampler = narrowed<kConfig>(full_sampler);
  UseRecorder<kConfig> recorder(sampler, use);
  for (std::size_t i = 0; i < lookups.size(); ++i) {
    const auto pixel = sample<kConfig>(make_request<kConfig>(lookups[i], 0), sampler, memory, recorder);
    for (std::size_t c = 0; c < 4; ++c) {
      colours[i][c] = static_cast<float>(Formats<kConfig>::kPixel.value(pixel.colour[c].raw()) / 255);
    }
  }
}

// Widths of one mantissa, numbered: the table is the slowest, weights are the fastest.
inline constexpr std::size_t kVariantsOfMantissa = Widths::kTableSides.size() * Widths::kSubtexelBits.size() *
                                                   Widths::kLevelFractionBits.size() * Widths::kWeightBits.size();
constexpr Widths numbered_widths(int mantissa_bits, std::size_t number) {
  const auto next = [&](const auto& choices) {
    const int chosen = choices[number % choices.size()];
    number /= choices.size();
    return chosen;
  };
  Widths widths;
  widths.mantissa_bits = mantissa_bits;
  widths.weight_bits = next(Widths::kWeightBits);
  widths.level_fraction_bits = next(Widths::kLevelFractionBits);
  widths.subtexel_bits = next(Widths::kSubtexelBits);
  widths.table_side = next(Widths::kTableSides);
  return widths;
}

template <std::size_t kPlace>
std::span<const Variant> variants_of_mantissa() {
  if constexpr (kPlace < Widths::kMantissaBits.size()) {
    static constexpr auto kVariants = []<std::size_t... kNumber>(std::index_sequence<kNumber...>) {
      constexpr int kMantissaBits = Widths::kMantissaBits[kPlace];
      return std::array{Variant{config_of(numbered_widths(kMantissaBits, kNumber)),
                                &sample_variant<config_of(numbered_widths(kMantissaBits, kNumber))>}...};
    }
    (std::make_index_sequence<kVariantsOfMantissa>());
    return kVariants;
  } else {
    return {};
  }
}

}  // namespace feline
