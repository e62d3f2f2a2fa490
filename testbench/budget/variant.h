// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "model/lookup.h"
#include "model/memory.h"
#include "tables/sampler_state.h"

namespace feline {

// What lookups needed of a unit beyond what its sampler state asks for: as far as it was reached.
struct VariantUse {
  std::uint64_t probes = 0;
  int least_exponent = 0;  // with the greatest, a range around 0
  int greatest_exponent = 0;
  int position_bits = 0;   // of the magnitude
  int wanted_probes = 1;   // before a footprint turned out wider than the 1 x 1 level
  int coarsest_level = 0;  // read
  bool blends = false;     // two levels in a probe
  bool linear = false;     // interpolated texels
  bool nearest = false;    // texels that are not
  bool translucent = false;
  int derivatives = 0;  // that are not 0: bits 0 to 3 are ds/dx, dt/dx, ds/dy, dt/dy

  bool operator==(const VariantUse&) const = default;
};
void merge(VariantUse& into, const VariantUse& from);

// The bit-accurate unit of one set of widths.
struct Variant {
  Config config;
  // Samples lookups in order; a colour in linear light, 1 is full. The sampler state is the default configuration's, of
  // a sampler without bias and limits of the level.
  void (*sample)(const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory,
                 std::span<const Lookup> lookups, std::span<std::array<float, 4>> colours, VariantUse& use);
};

// Of a width, rising: the default configuration's, and before it what is narrower of two.
class WidthChoices {
 public:
  constexpr WidthChoices(int widest, int low, int middle) {
    for (const int each : {low, middle}) {
      if (each < widest && (count_ == 0 || each > back())) choices_[count_++] = each;
    }
    choices_[count_++] = widest;
  }
  constexpr const int* begin() const { return choices_.data(); }
  constexpr const int* end() const { return begin() + count_; }
  constexpr std::size_t size() const { return count_; }
  constexpr int front() const { return choices_[0]; }
  constexpr int back() const { return choices_[count_ - 1]; }
  constexpr int operator[](std::size_t place) const { return choices_[place]; }

 private:
  std::array<int, 3> choices_{};
  std::size_t count_ = 0;
};

// The widths that are searched; every combination is a variant. The widest is the default configuration.
struct Widths {
  static constexpr WidthChoices kMantissaBits{kDefaultConfig.mantissa_bits, 6, 7};
  // Of the ellipse table, which has at most so many rows and columns.
  static constexpr WidthChoices kTableSides{std::max(kDefaultConfig.table_rows, kDefaultConfig.table_columns), 8, 8};
  static constexpr WidthChoices kSubtexelBits{kDefaultConfig.subtexel_bits, 5, 5};
  static constexpr WidthChoices kLevelFractionBits{kDefaultConfig.level_fraction_bits, 5, 5};
  static constexpr WidthChoices kWeightBits{kDefaultConfig.weight_bits, 6, 6};

  int mantissa_bits = kMantissaBits.back();
  int table_side = kTableSides.back();
  int subtexel_bits = kSubtexelBits.back();
  int level_fraction_bits = kLevelFractionBits.back();
  int weight_bits = kWeightBits.back();

  constexpr bool operator==(const Widths&) const = default;
};

// Positions get as many bits below a sub-texel as the default configuration's.
constexpr Config config_of(const Widths& widths) {
  Config config;
  config.mantissa_bits = widths.mantissa_bits;
  config.table_rows = std::min(config.table_rows, widths.table_side);
  config.table_columns = std::min(config.table_columns, widths.table_side);
  config.subtexel_bits = widths.subtexel_bits;
  config.level_fraction_bits = widths.level_fraction_bits;
  config.weight_bits = widths.weight_bits;
  return config;
}
static_assert(config_of({}) == kDefaultConfig);

// Throws std::out_of_range for widths that are not searched.
const Variant& variant_of(const Widths& widths);

// Those of one choice of mantissa, if there is one, in the order of the other widths. A source of its own each: each
// takes the compiler long.
std::span<const Variant> variants_of_first_mantissa();
std::span<const Variant> variants_of_second_mantissa();
std::span<const Variant> variants_of_third_mantissa();

}  // namespace feline
