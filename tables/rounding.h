// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

namespace feline {

// The bits that value >= 0 needs: 0 for 0, 1 for 1, 3 for 7.
constexpr int bit_length(std::int64_t value) {
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}

// The rounding verbs. Each drops `bits` fraction bits, 0 <= bits; every stage names the one it uses.
//
//   value          -1.75  -1.5  -1.25  -1  1  1.25  1.5  1.75
//   round_down        -2    -2     -2  -1  1     1    1     1    towards minus infinity
//   round_up_ties     -2    -1     -1  -1  1     1    2     2    nearest, ties up
//   round_away_ties   -2    -2     -1  -1  1     1    2     2    nearest, ties away from zero: odd symmetric
//   round_outward     -2    -2     -2  -1  1     2    2     2    away from zero: odd symmetric, never smaller

constexpr std::int64_t round_down(std::int64_t value, int bits) {
  return bits > 62 ? (value < 0 ? -1 : 0) : value >> bits;
}

constexpr std::int64_t round_up_ties(std::int64_t value, int bits) {
  return bits == 0 ? value : (value + (std::int64_t{1} << (bits - 1))) >> bits;
}

// Any shift is legal; one that drops every bit gives 0. |value| < 2^62.
constexpr std::int64_t round_away_ties(std::int64_t value, int bits) {
  if (bits == 0) return value;
  if (bits > 62) return 0;
  const std::int64_t magnitude = ((value < 0 ? -value : value) + (std::int64_t{1} << (bits - 1))) >> bits;
  return value < 0 ? -magnitude : magnitude;
}

// Any shift is legal; one that drops every bit of a value other than 0 gives 1 or -1. |value| < 2^62.
constexpr std::int64_t round_outward(std::int64_t value, int bits) {
  const std::int64_t magnitude = value < 0 ? -value : value;
  const std::int64_t kept = bits > 62 ? 0 : magnitude >> bits;
  const bool inexact = bits > 62 ? magnitude != 0 : (kept << bits) != magnitude;
  const std::int64_t rounded = kept + (inexact ? 1 : 0);
  return value < 0 ? -rounded : rounded;
}

}  // namespace feline
