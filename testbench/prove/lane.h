// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "tables/format.h"

// A lane is one input or output of a leaf, packed into 64-bit words: bit 0 of word 0 is the lowest bit of the last
// field.
namespace feline::prove {

// Raw values of fields.
template <const auto& kFields>
using Values = std::array<std::int64_t, kFields.size()>;

template <const auto& kFields>
constexpr int fields_width() {
  int width = 0;
  for (const Format& field : kFields) width += field.width();
  return width;
}

template <const auto& kFields>
constexpr std::size_t lane_words() {
  return (static_cast<std::size_t>(fields_width<kFields>()) + 63) / 64;
}

// The place of a field's lowest bit.
template <const auto& kFields>
constexpr int field_place(std::size_t index) {
  int place = 0;
  for (std::size_t i = index + 1; i < kFields.size(); ++i) place += kFields[i].width();
  return place;
}

// Both evaluate `count` lanes, one after the other. Explicitly instantiated where the leaf's functions are defined.
template <typename Leaf>
void evaluate_model(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count);
template <typename Leaf>
void evaluate_exact(const std::uint64_t* inputs, std::uint64_t* outputs, std::size_t count);

}  // namespace feline::prove
