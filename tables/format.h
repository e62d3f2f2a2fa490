// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace feline {

// A string that can be part of a type.
struct Name {
  std::array<char, 32> text{};

  constexpr Name() = default;
  template <std::size_t kLength>
  consteval Name(const char (&literal)[kLength]) {  // NOLINT(google-explicit-constructor)
    static_assert(kLength <= 32, "a name has at most 31 characters");
    std::copy_n(literal, kLength, text.begin());
  }
  constexpr std::string_view view() const { return {text.data()}; }
  constexpr bool operator==(const Name&) const = default;
};

// A fixed-point number format: value = raw * 2^-fraction_bits, in the unit named. Written U4.8 or S5.8 in comments:
// signedness, integer bits, fraction bits; the sign bit of an S format is one more.
struct Format {
  Name name;
  bool is_signed = false;
  int integer_bits = 0;
  int fraction_bits = 0;
  Name unit;

  constexpr int width() const { return integer_bits + fraction_bits + (is_signed ? 1 : 0); }
  constexpr std::int64_t max_raw() const { return (std::int64_t{1} << (integer_bits + fraction_bits)) - 1; }
  constexpr std::int64_t min_raw() const { return is_signed ? -max_raw() - 1 : 0; }
  constexpr std::int64_t one() const { return std::int64_t{1} << fraction_bits; }
  constexpr double value(std::int64_t raw) const {
    return static_cast<double>(raw) / static_cast<double>(std::int64_t{1} << fraction_bits);
  }
  constexpr bool operator==(const Format&) const = default;
};

// Ends the program: a value left its format, which is a bug in the model, never a property of the input.
[[noreturn]] void format_overflow(const Format& format, std::int64_t raw);

// A number whose type is its format. Formats of equal width do not mix: Fixed<kLevelOfDetail> is not Fixed<kWeight>.
template <Format kFormat>
class Fixed {
 public:
  static constexpr Format kFormatOf = kFormat;

  constexpr Fixed() = default;
  // Checked in every build: a raw value outside the format ends the program.
  static constexpr Fixed from_raw(std::int64_t raw) {
    if (raw < kFormat.min_raw() || raw > kFormat.max_raw()) format_overflow(kFormat, raw);
    Fixed fixed;
    fixed.raw_ = raw;
    return fixed;
  }
  static constexpr Fixed saturate(std::int64_t raw) {
    return from_raw(std::clamp(raw, kFormat.min_raw(), kFormat.max_raw()));
  }
  constexpr std::int64_t raw() const { return raw_; }
  constexpr double value() const { return kFormat.value(raw_); }
  constexpr bool operator==(const Fixed&) const = default;

 private:
  std::int64_t raw_ = 0;
};

}  // namespace feline
