// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/float_patterns.h"

#include <bit>

namespace feline {
namespace {

constexpr std::uint32_t kFractionBits = 23;
constexpr std::uint32_t kAll = (1U << kFractionBits) - 1;

// 0; a bit; ones from the lowest bit, two to all of them; ones from the highest, two to all but one.
constexpr std::uint32_t significand(std::uint32_t index) {
  if (index == 0) return 0;
  index -= 1;
  if (index < kFractionBits) return 1U << index;
  index -= kFractionBits;
  if (index < kFractionBits - 1) return kAll >> (kFractionBits - 2 - index);
  index -= kFractionBits - 1;
  return kAll & (kAll << (index + 1));
}

static_assert(kSignificandPatterns == 1 + kFractionBits + (kFractionBits - 1) + (kFractionBits - 2));
static_assert(significand(kSignificandPatterns - 1) == (3U << (kFractionBits - 2)));

}  // namespace

float float_pattern(std::uint32_t index) {
  const std::uint32_t fraction = significand(index % kSignificandPatterns);
  const std::uint32_t sign_and_exponent = index / kSignificandPatterns;
  return std::bit_cast<float>(sign_and_exponent << kFractionBits | fraction);
}

}  // namespace feline
