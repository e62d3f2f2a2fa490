// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/random.h"

namespace feline {

inline float float_of(std::uint32_t bits) { return std::bit_cast<float>(bits); }

// One float32 of each class and edge, for pairwise combinations; the negative ones, too.
inline constexpr std::array<std::uint32_t, 30> kFloatLattice{
    0x00000000, 0x80000000,  // zeros
    0x00000001, 0x807fffff,  // denormals
    0x00800000, 0x80800000,  // least normals
    0x7f7fffff, 0xff7fffff,  // greatest
    0x7f800000, 0xff800000,  // infinities
    0x7fc00000, 0xff800001,  // NaNs, quiet and signalling
    0x3f800000, 0xbf800000,  // 1
    0x3f000000, 0x3effffff,  // 1/2 and below
    0x3f7fffff, 0x3f800001,  // around 1
    0x33000000, 0x33000001,  // 2^-25: half of a position's last bit, and more
    0x49000000, 0x48ffffff,  // 2^19: where clamps saturate
    0xca000000, 0xd3000000,  // -2^21, -2^39
    0x3b800000, 0x3b7f0000,  // 2^-8, 255/256 of it
    0x3c000000, 0xbc3e0000,  // 2^-7, -0.0116
    0x5f000000, 0x20000000,  // 2^63, 2^-63
};

inline float float_with(Random& random, int low_exponent, int high_exponent) {
  const auto exponent = static_cast<std::uint32_t>(random.between(low_exponent, high_exponent) + 127);
  const auto rest = static_cast<std::uint32_t>(random.bits());
  return float_of((rest & 0x807fffff) | (exponent << 23));
}

// A float of any class: the classes are equally likely, so each meets each.
inline float any_float(Random& random) {
  const auto rest = static_cast<std::uint32_t>(random.bits());
  const std::uint32_t sign = rest & 0x80000000;
  switch (random.below(12)) {
    case 0: return float_of(rest);                                                 // uniform bits
    case 1: return float_of(sign | 0x7f800000 | (rest & 0x7fffff));                // NaN
    case 2: return float_of(sign | 0x7f800000);                                    // infinity
    case 3: return float_of(sign | (rest & 0x7fffff));                             // denormal
    case 4: return float_of(sign);                                                 // zero
    case 5: return float_of(sign | (random.one_in(2) ? 0x00800000 : 0x7f7fffff));  // least and greatest normal
    case 6: return float_with(random, -126, 127);
    case 7: return std::ldexp(sign != 0 ? -1.0F : 1.0F, static_cast<int>(random.between(-126, 127)));
    case 8: {  // near a tie of the position, or of a group mantissa
      const auto steps = static_cast<float>(random.between(-65535, 65535)) + 0.5F;
      return std::nextafter(std::ldexp(steps, -static_cast<int>(random.between(6, 32))),
                            random.one_in(2) ? 1e9F : -1e9F);
    }
    case 9: return float_with(random, -16, 4);
    case 10: return float_with(random, -30, 24);
    default: return float_of(kFloatLattice[static_cast<std::size_t>(random.below(30))]);
  }
}

}  // namespace feline
