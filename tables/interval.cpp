// SPDX-License-Identifier: Apache-2.0
#include "tables/interval.h"

#include <algorithm>
#include <stdexcept>

namespace feline {
namespace {

constexpr Int128 kOne = Int128{1} << Interval::kFraction;

Int128 floor_shift(Int128 value) { return value >> Interval::kFraction; }
Int128 ceil_shift(Int128 value) { return -((-value) >> Interval::kFraction); }

Int128 floor_divide(Int128 a, Int128 b) {
  const Int128 quotient = a / b;
  return quotient * b != a && (a < 0) != (b < 0) ? quotient - 1 : quotient;
}

// Digit by digit, without division.
Int128 floor_root(Int128 square) {
  Int128 root = 0;
  Int128 bit = Int128{1} << 124;
  while (bit > square) bit >>= 2;
  for (; bit != 0; bit >>= 2) {
    if (square >= root + bit) {
      square -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return root;
}

Int128 floor_at(Int128 value, int fraction_bits) { return value >> (Interval::kFraction - fraction_bits); }

}  // namespace

Interval Interval::integer(std::int64_t value) { return ratio(value, 1); }

Interval Interval::ratio(std::int64_t numerator, std::int64_t denominator) {
  Interval result;
  result.low_ = floor_divide(Int128{numerator} << kFraction, denominator);
  result.high_ = -floor_divide(-(Int128{numerator} << kFraction), denominator);
  return result;
}

Interval operator+(Interval a, Interval b) {
  a.low_ += b.low_;
  a.high_ += b.high_;
  return a;
}

Interval operator-(Interval a, Interval b) {
  Interval result;
  result.low_ = a.low_ - b.high_;
  result.high_ = a.high_ - b.low_;
  return result;
}

Interval operator*(Interval a, Interval b) {
  const auto products = std::minmax({a.low_ * b.low_, a.low_ * b.high_, a.high_ * b.low_, a.high_ * b.high_});
  Interval result;
  result.low_ = floor_shift(products.first);
  result.high_ = ceil_shift(products.second);
  return result;
}

Interval operator/(Interval a, Interval b) {
  if (b.low_ <= 0 && b.high_ >= 0) throw std::domain_error("interval division by zero");
  const auto quotient = [](Int128 x, Int128 y) { return floor_divide(x * kOne, y); };
  const auto quotients = std::minmax(
      {quotient(a.low_, b.low_), quotient(a.low_, b.high_), quotient(a.high_, b.low_), quotient(a.high_, b.high_)});
  Interval result;
  result.low_ = quotients.first;
  result.high_ = quotients.second + 1;
  return result;
}

Interval Interval::clamped(std::int64_t low, std::int64_t high) const {
  Interval result;
  result.low_ = std::clamp(low_, low * kOne, high * kOne);
  result.high_ = std::clamp(high_, low * kOne, high * kOne);
  return result;
}

std::int64_t Interval::certified_round(int fraction_bits) const {
  const Int128 half = Int128{1} << (kFraction - fraction_bits - 1);
  const Int128 low = floor_at(low_ + half, fraction_bits);
  if (low != floor_at(high_ + half, fraction_bits)) throw std::domain_error("rounding is not certain");
  return static_cast<std::int64_t>(low);
}

std::int64_t Interval::certified_floor(int fraction_bits) const {
  const Int128 low = floor_at(low_, fraction_bits);
  if (low != floor_at(high_, fraction_bits)) throw std::domain_error("rounding is not certain");
  return static_cast<std::int64_t>(low);
}

double Interval::middle() const { return static_cast<double>(low_ + high_) / static_cast<double>(2 * kOne); }

Interval square_root(Interval a) {
  Interval result;
  result.low_ = floor_root(std::max(a.low_, Int128{0}) << Interval::kFraction);
  result.high_ = floor_root(std::max(a.high_, Int128{0}) << Interval::kFraction) + 1;
  if (a.high_ == 0) result.high_ = 0;
  return result;
}

Interval exponential(Interval a) {
  Interval sum = Interval::integer(1);
  Interval term = Interval::integer(1);
  // 4^60 / 60! < 2^-150: the remainder is far below one unit of the enclosure, which the last line adds.
  for (int n = 1; n <= 60; ++n) {
    term = term * a / Interval::integer(n);
    sum = sum + term;
  }
  sum.low_ -= 1;
  sum.high_ += 1;
  return sum;
}

Interval logarithm2(Interval a) {
  constexpr int kDigits = 30;
  Int128 digits = 0;
  const Interval half = Interval::ratio(1, 2);
  for (int i = 0; i < kDigits; ++i) {
    a = a * a;
    if (a.low_ < 2 * kOne && a.high_ >= 2 * kOne) throw std::domain_error("logarithm digit is not certain");
    const bool one = a.low_ >= 2 * kOne;
    if (one) a = a * half;
    digits = 2 * digits + (one ? 1 : 0);
  }
  Interval result;
  result.low_ = digits << (Interval::kFraction - kDigits);
  // A power of two is exact: every remaining digit is 0.
  result.high_ =
      a.low_ == kOne && a.high_ == kOne ? result.low_ : result.low_ + (Int128{1} << (Interval::kFraction - kDigits));
  return result;
}

Interval fifth_root(Interval a) {
  const auto fifth_power = [](Int128 root) {
    Interval x;
    x.low_ = x.high_ = root;
    return x * x * x * x * x;
  };
  constexpr int kStep = Interval::kFraction - 40;
  Int128 low = 0;
  for (Int128 bit = kOne; bit >= (Int128{1} << kStep); bit >>= 1) {
    if (low + bit <= kOne && fifth_power(low + bit).high_ <= a.low_) low += bit;
  }
  Int128 high = low + (Int128{1} << kStep);
  while (fifth_power(high).low_ < a.high_) high += Int128{1} << kStep;
  Interval result;
  result.low_ = low;
  result.high_ = low == kOne ? kOne : high;
  return result;
}

}  // namespace feline
