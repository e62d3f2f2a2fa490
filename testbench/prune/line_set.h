// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace feline {

// Which of a texture's memory lines were read: one bit a line.
class LineSet {
 public:
  LineSet() = default;
  explicit LineSet(std::size_t size) : size_(size), words_((size + 63) / 64) {}

  std::size_t size() const { return size_; }
  bool contains(std::size_t line) const { return (words_[line / 64] >> (line % 64) & 1) != 0; }
  void insert(std::size_t line) { words_[line / 64] |= std::uint64_t{1} << (line % 64); }
  // Of an equal size.
  void insert(const LineSet& other) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
  }
  std::size_t count(std::size_t first, std::size_t end) const {
    std::size_t lines = 0;
    for (std::size_t line = first; line < end; ++line) lines += contains(line) ? 1 : 0;
    return lines;
  }
  std::size_t count() const {
    std::size_t lines = 0;
    for (const std::uint64_t word : words_) lines += static_cast<std::size_t>(std::popcount(word));
    return lines;
  }
  bool operator==(const LineSet&) const = default;

 private:
  std::size_t size_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace feline
