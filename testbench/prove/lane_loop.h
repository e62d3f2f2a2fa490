// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>

#include "testbench/prove/lane.h"

namespace feline::prove {

template <const auto& kFields, std::size_t kIndex>
constexpr std::int64_t unpack_field(const std::uint64_t* lane) {
  constexpr int kWidth = kFields[kIndex].width();
  constexpr int kPlace = field_place<kFields>(kIndex);
  constexpr int kShift = kPlace % 64;
  static_assert(kWidth > 0 && kWidth < 64);
  std::uint64_t bits = lane[kPlace / 64] >> kShift;
  if constexpr (kShift + kWidth > 64) bits |= lane[kPlace / 64 + 1] << (64 - kShift);
  // To the top, and back with the sign or zeros.
  bits <<= 64 - kWidth;
  if constexpr (kFields[kIndex].is_signed) return static_cast<std::int64_t>(bits) >> (64 - kWidth);
  return static_cast<std::int64_t>(bits >> (64 - kWidth));
}

template <const auto& kFields, std::size_t kIndex>
constexpr void pack_field(std::int64_t value, std::uint64_t* lane) {
  constexpr int kWidth = kFields[kIndex].width();
  constexpr int kPlace = field_place<kFields>(kIndex);
  constexpr int kShift = kPlace % 64;
  const std::uint64_t bits = static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << kWidth) - 1);
  lane[kPlace / 64] |= bits << kShift;
  if constexpr (kShift + kWidth > 64) lane[kPlace / 64 + 1] |= bits >> (64 - kShift);
}

template <const auto& kFields>
constexpr std::array<std::int64_t, kFields.size()> unpack_lane(const std::uint64_t* lane) {
  return [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    return std::array<std::int64_t, kFields.size()>{unpack_field<kFields, kIndex>(lane)...};
  }
  (std::make_index_sequence<kFields.size()>());
}

// `lane` holds zeros. Values that do not fit lose their high bits, and are then unequal to what does.
template <const auto& kFields>
constexpr void pack_lane(const std::array<std::int64_t, kFields.size()>& values, std::uint64_t* lane) {
  [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (pack_field<kFields, kIndex>(values[kIndex], lane), ...);
  }
  (std::make_index_sequence<kFields.size()>());
}

// Flattened: an array that is stored by parts and loaded as a whole, as a call would, waits for the store each time.
template <typename Leaf, auto kFunction>
[[gnu::flatten]] void evaluate_lanes(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count) {
  constexpr std::size_t kInputWords = lane_words<Leaf::kInputs>();
  constexpr std::size_t kOutputWords = lane_words<Leaf::kOutputs>();
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::uint64_t, kOutputWords> lane{};
    pack_lane<Leaf::kOutputs>(kFunction(unpack_lane<Leaf::kInputs>(inputs + i * kInputWords)), lane.data());
    for (std::size_t k = 0; k < kOutputWords; ++k) outputs[i * kOutputWords + k] = lane[k];
  }
}

template <typename Leaf>
void evaluate_model(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count) {
  evaluate_lanes<Leaf, &Leaf::model>(inputs, outputs, count);
}

template <typename Leaf>
void evaluate_exact(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count) {
  evaluate_lanes<Leaf, &Leaf::exact>(inputs, outputs, count);
}

}  // namespace feline::prove
