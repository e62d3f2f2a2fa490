// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/coverage/point.h"

namespace feline::coverage {

// Functional bins that belong together, as rows and columns: a cell counts how often the suite was there. A cell
// without a count is no bin, since nothing can be there by what rows and columns mean.
class BinGrid {
 public:
  struct Axis {
    std::string text;                // what rows or columns are
    std::vector<std::string> names;  // of each
  };

  BinGrid(std::string name, std::string text, Axis rows, Axis columns)
      : name_(std::move(name)),
        text_(std::move(text)),
        rows_(std::move(rows)),
        columns_(std::move(columns)),
        counts_(rows_.names.size() * columns_.names.size(), 0) {}

  const std::string& name() const { return name_; }  // one word
  const std::string& text() const { return text_; }  // for the page
  const Axis& rows() const { return rows_; }
  const Axis& columns() const { return columns_; }
  const std::vector<std::optional<std::uint64_t>>& counts() const { return counts_; }  // row by row

  // Says that a cell is no bin.
  void leave_out(std::size_t row, std::size_t column) { counts_.at(at(row, column)).reset(); }
  // Of a cell; none where it is no bin.
  std::optional<std::uint64_t> count_of(std::size_t row, std::size_t column) const {
    return counts_.at(at(row, column));
  }
  // True the first time. std::logic_error for a cell that is no bin: what rows and columns mean is wrong.
  bool count(std::size_t row, std::size_t column);
  // "name/row, column": what exclusions and the ratchet call a bin.
  std::string bin_name(std::size_t row, std::size_t column) const;

 private:
  friend nlohmann::ordered_json to_json(const std::vector<BinGrid>& grids);
  friend std::vector<BinGrid> read_bin_grids(const std::filesystem::path& file);
  std::size_t at(std::size_t row, std::size_t column) const { return row * columns_.names.size() + column; }

  std::string name_;
  std::string text_;
  Axis rows_;
  Axis columns_;
  std::vector<std::optional<std::uint64_t>> counts_;
};

nlohmann::ordered_json to_json(const std::vector<BinGrid>& grids);
// Throws InputError naming the file and what is wrong with it.
std::vector<BinGrid> read_bin_grids(const std::filesystem::path& file);

// A point for each bin.
std::vector<Point> bin_points(const std::vector<BinGrid>& grids);

// "first" to "last".
std::vector<std::string> numbers(int first, int last);
std::vector<std::string> words(std::initializer_list<std::string_view> names);

}  // namespace feline::coverage
