// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace feline {

// Every sign and exponent of float32 with every significand of a set, after Berkeley TestFloat's patterns: none, one
// bit, a run of ones from either end; zeros, denormals, infinities and NaNs are among them.
inline constexpr std::uint32_t kSignificandPatterns = 67;
inline constexpr std::uint32_t kFloatPatterns = 2 * 256 * kSignificandPatterns;

// index < kFloatPatterns.
float float_pattern(std::uint32_t index);

}  // namespace feline
