// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tables/beats.h"

namespace feline {

template <typename T>
struct FieldShape;  // how a field's type is laid out: a format, and how many of them
template <Format kFormat>
struct FieldShape<Fixed<kFormat>> {
  static constexpr Format kFormatOf = kFormat;
  static constexpr int kCount = 1;
  static constexpr bool kIsArray = false;
};
template <Format kFormat, std::size_t kSize>
struct FieldShape<std::array<Fixed<kFormat>, kSize>> {
  static constexpr Format kFormatOf = kFormat;
  static constexpr int kCount = static_cast<int>(kSize);
  static constexpr bool kIsArray = true;
};

// Calls visit(name, format, count, is_array) for each field of a beat type, in order.
template <typename Beat, typename Visit>
constexpr void for_each_shape(Visit visit) {
  std::apply(
      [&](const auto&... field) {
        (
            [&]<typename Member>(Member Beat::*, Name name) {
              using Shape = FieldShape<Member>;
              visit(name, Shape::kFormatOf, Shape::kCount, Shape::kIsArray);
            }(field.member, field.name),
            ...);
      },
      Beat::fields());
}

template <typename Beat>
constexpr int beat_width() {
  int width = 0;
  for_each_shape<Beat>([&](Name, const Format& format, int count, bool) { width += format.width() * count; });
  return width;
}

template <typename Beat>
constexpr int beat_words() {
  return (beat_width<Beat>() + 31) / 32;
}

// Calls visit(name, element, value) for each scalar of a beat, in order; element is -1 for a field that is no array.
// Elements of an array are visited from the last to the first, which is the order of their bits from the highest.
template <typename Beat, typename Visit>
constexpr void for_each_value(Beat& beat, Visit visit) {
  std::apply(
      [&](const auto&... field) {
        (
            [&](const Name& name, auto& member) {
              if constexpr (requires { member.size(); }) {
                for (std::size_t i = member.size(); i-- > 0;) visit(name, static_cast<int>(i), member[i]);
              } else {
                visit(name, -1, member);
              }
            }(field.name, beat.*(field.member)),
            ...);
      },
      std::remove_const_t<Beat>::fields());
}

// A beat as the RTL's packed struct holds it: bit 0 of word 0 is the lowest bit of the last field.
template <typename Beat>
void pack(const Beat& beat, std::span<std::uint32_t> words) {
  for (auto& word : words) word = 0;
  int position = beat_width<Beat>();
  for_each_value(beat, [&]<Format kFormat>(const Name&, int, const Fixed<kFormat>& value) {
    constexpr int kWidth = kFormat.width();
    position -= kWidth;
    auto bits = static_cast<std::uint64_t>(value.raw()) & ((std::uint64_t{1} << kWidth) - 1);
    for (int at = position; bits != 0; at += 32 - at % 32) {
      words[static_cast<std::size_t>(at / 32)] |= static_cast<std::uint32_t>(bits << (at % 32));
      bits >>= 32 - at % 32;
    }
  });
}

template <typename Beat>
Beat unpack(std::span<const std::uint32_t> words) {
  Beat beat;
  int position = beat_width<Beat>();
  for_each_value(beat, [&]<Format kFormat>(const Name&, int, Fixed<kFormat>& value) {
    constexpr int kWidth = kFormat.width();
    position -= kWidth;
    std::uint64_t bits = 0;
    for (int done = 0; done < kWidth;) {
      const int at = position + done;
      bits |= static_cast<std::uint64_t>(words[static_cast<std::size_t>(at / 32)] >> (at % 32)) << done;
      done += 32 - at % 32;
    }
    bits &= (std::uint64_t{1} << kWidth) - 1;
    auto raw = static_cast<std::int64_t>(bits);
    if (kFormat.is_signed && (bits >> (kWidth - 1)) != 0) raw -= std::int64_t{1} << kWidth;
    value = Fixed<kFormat>::from_raw(raw);
  });
  return beat;
}

// One scalar of a beat, told apart from its type.
struct FieldValue {
  std::string name;  // colour.r, fine_line[2], level_of_detail
  Format format;
  std::int64_t raw = 0;
};

std::string element_name(std::string_view field, int element, int count);
// The bits of a value, as wide as its format: 0x3f.
std::string hex_text(const FieldValue& value);

template <typename Beat>
std::vector<FieldValue> field_values(const Beat& beat) {
  std::vector<FieldValue> values;
  std::apply(
      [&](const auto&... field) {
        (
            [&](const Name& name, const auto& member) {
              if constexpr (requires { member.size(); }) {
                for (std::size_t i = 0; i < member.size(); ++i) {
                  values.push_back({element_name(name.view(), static_cast<int>(i), static_cast<int>(member.size())),
                                    member[i].kFormatOf, member[i].raw()});
                }
              } else {
                values.push_back({std::string(name.view()), member.kFormatOf, member.raw()});
              }
            }(field.name, beat.*(field.member)),
            ...);
      },
      Beat::fields());
  return values;
}

template <typename Beat>
bool same(const Beat& left, const Beat& right) {
  return std::apply([&](const auto&... field) { return ((left.*(field.member) == right.*(field.member)) && ...); },
                    Beat::fields());
}

}  // namespace feline
