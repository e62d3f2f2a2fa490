// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace feline {

__extension__ using Int128 = __int128;

// A real number enclosed between two multiples of 2^-56, by integer arithmetic only, so that every host gets the same
// bits. Magnitudes stay below 2^7; the functions below round outwards.
class Interval {
 public:
  static constexpr int kFraction = 56;

  constexpr Interval() = default;
  static Interval integer(std::int64_t value);
  static Interval ratio(std::int64_t numerator, std::int64_t denominator);

  friend Interval operator+(Interval a, Interval b);
  friend Interval operator-(Interval a, Interval b);
  friend Interval operator*(Interval a, Interval b);
  friend Interval operator/(Interval a, Interval b);  // b must not hold 0

  Interval clamped(std::int64_t low, std::int64_t high) const;
  // The nearest multiple of 2^-fraction_bits, as an integer; throws std::domain_error when the enclosure leaves it
  // open.
  std::int64_t certified_round(int fraction_bits) const;
  // The largest multiple of 2^-fraction_bits that is not greater; throws when the enclosure leaves it open.
  std::int64_t certified_floor(int fraction_bits) const;
  double middle() const;
  bool certainly_less(Interval other) const { return high_ < other.low_; }

 private:
  friend Interval square_root(Interval a);
  friend Interval exponential(Interval a);
  friend Interval logarithm2(Interval a);
  friend Interval fifth_root(Interval a);

  Int128 low_ = 0;
  Int128 high_ = 0;
};

Interval square_root(Interval a);  // a >= 0
Interval exponential(Interval a);  // -4 <= a <= 4
Interval logarithm2(Interval a);   // 1 <= a < 2; 30 correct bits
Interval fifth_root(Interval a);   // 0 <= a <= 1

}  // namespace feline
