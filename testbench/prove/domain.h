// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "testbench/prove/lane_loop.h"

namespace feline::prove {

// The inputs over which a leaf is enumerated, numbered from 0.
struct Domain {
  std::string text;  // what it covers
  std::uint64_t count = 0;
  // Packs the inputs first .. first + lanes - 1, one after the other.
  std::function<void(std::uint64_t first, std::size_t lanes, std::uint64_t* out)> fill;
};

// The values of one field: a range, or a list.
class Axis {
 public:
  Axis(std::int64_t value) : values_{value} {}  // NOLINT(google-explicit-constructor)
  explicit Axis(std::vector<std::int64_t> values) : values_(std::move(values)) {}
  static Axis range(std::int64_t first, std::int64_t last) {
    Axis axis{std::vector<std::int64_t>{}};
    axis.first_ = first;
    axis.count_ = static_cast<std::uint64_t>(last - first) + 1;
    return axis;
  }
  // Every value of a format.
  static Axis all(const Format& format) { return range(format.min_raw(), format.max_raw()); }

  std::uint64_t count() const { return values_.empty() ? count_ : values_.size(); }
  std::int64_t operator[](std::uint64_t i) const {
    return values_.empty() ? first_ + static_cast<std::int64_t>(i) : values_[i];
  }

 private:
  std::vector<std::int64_t> values_;
  std::int64_t first_ = 0;
  std::uint64_t count_ = 0;
};

// Every combination of axes, one a field, the last field fastest.
template <typename Leaf>
Domain product(std::string text, std::vector<Axis> axes) {
  constexpr std::size_t kFields = Leaf::kInputs.size();
  constexpr std::size_t kWords = lane_words<Leaf::kInputs>();
  std::uint64_t count = 1;
  for (const Axis& axis : axes) count *= axis.count();
  const auto fill = [axes = std::move(axes)](std::uint64_t first, std::size_t lanes, std::uint64_t* out) {
    const Axis& fastest = axes[kFields - 1];
    std::uint64_t row = first / fastest.count();
    std::uint64_t column = first % fastest.count();
    while (lanes > 0) {
      std::array<std::int64_t, kFields> values{};
      std::uint64_t rest = row;
      for (std::size_t i = kFields - 1; i-- > 0;) {
        values[i] = axes[i][rest % axes[i].count()];
        rest /= axes[i].count();
      }
      std::array<std::uint64_t, kWords> lane{};
      pack_lane<Leaf::kInputs>(values, lane.data());
      for (; lanes > 0 && column < fastest.count(); --lanes, ++column, out += kWords) {
        std::copy(lane.begin(), lane.end(), out);
        pack_field<Leaf::kInputs, kFields - 1>(fastest[column], out);
      }
      ++row;
      column = 0;
    }
  };
  return {std::move(text), count, fill};
}

// One after the other.
inline Domain joined(std::string text, std::size_t words, std::vector<Domain> parts) {
  std::uint64_t count = 0;
  for (const Domain& part : parts) count += part.count;
  const auto fill = [words, parts = std::move(parts)](std::uint64_t first, std::size_t lanes, std::uint64_t* out) {
    for (const Domain& part : parts) {
      if (lanes == 0) return;
      if (first >= part.count) {
        first -= part.count;
        continue;
      }
      const auto some = static_cast<std::size_t>(std::min<std::uint64_t>(lanes, part.count - first));
      part.fill(first, some, out);
      out += some * words;
      lanes -= some;
      first = 0;
    }
  };
  return {std::move(text), count, fill};
}

// Rows of different length: `first_of` gives the first input of a row, whose last field counts up from there.
template <typename Leaf>
Domain rows(std::string text, std::uint64_t row_count, const std::function<std::uint64_t(std::uint64_t)>& length_of,
            std::function<Values<Leaf::kInputs>(std::uint64_t)> first_of) {
  constexpr std::size_t kFields = Leaf::kInputs.size();
  constexpr std::size_t kWords = lane_words<Leaf::kInputs>();
  std::vector<std::uint64_t> ends(row_count);
  std::uint64_t count = 0;
  for (std::uint64_t row = 0; row < row_count; ++row) ends[row] = count += length_of(row);
  const auto fill = [ends = std::move(ends), first_of = std::move(first_of)](std::uint64_t first, std::size_t lanes,
                                                                             std::uint64_t* out) {
    auto row = static_cast<std::uint64_t>(std::ranges::upper_bound(ends, first) - ends.begin());
    while (lanes > 0) {
      Values<Leaf::kInputs> values = first_of(row);
      const std::uint64_t start = row == 0 ? 0 : ends[row - 1];
      std::int64_t last = values[kFields - 1] + static_cast<std::int64_t>(first - start);
      values[kFields - 1] = 0;
      std::array<std::uint64_t, kWords> lane{};
      pack_lane<Leaf::kInputs>(values, lane.data());
      for (; lanes > 0 && first < ends[row]; --lanes, ++first, ++last, out += kWords) {
        std::copy(lane.begin(), lane.end(), out);
        pack_field<Leaf::kInputs, kFields - 1>(last, out);
      }
      ++row;
    }
  };
  return {std::move(text), count, fill};
}

// Input number i, for lattices.
template <typename Leaf>
Domain mapped(std::string text, std::uint64_t count, std::function<Values<Leaf::kInputs>(std::uint64_t)> input_of) {
  constexpr std::size_t kWords = lane_words<Leaf::kInputs>();
  const auto fill = [input_of = std::move(input_of)](std::uint64_t first, std::size_t lanes, std::uint64_t* out) {
    for (; lanes > 0; --lanes, ++first, out += kWords) {
      std::fill_n(out, kWords, 0);
      pack_lane<Leaf::kInputs>(input_of(first), out);
    }
  };
  return {std::move(text), count, fill};
}

// Takes numbers apart: take(n) is the rest by n, and what is left is the quotient.
class Digits {
 public:
  explicit Digits(std::uint64_t number) : rest_(number) {}
  std::int64_t take(std::uint64_t base) {
    const std::uint64_t digit = rest_ % base;
    rest_ /= base;
    return static_cast<std::int64_t>(digit);
  }

 private:
  std::uint64_t rest_;
};

}  // namespace feline::prove
