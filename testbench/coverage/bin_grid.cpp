// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/bin_grid.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "testbench/error.h"
#include "testbench/json_input.h"

namespace feline::coverage {

bool BinGrid::count(std::size_t row, std::size_t column) {
  if (row >= rows_.names.size() || column >= columns_.names.size() || !counts_[at(row, column)]) {
    throw std::logic_error(fmt::format("{} has no bin in row {}, column {}", name_, row, column));
  }
  return (*counts_[at(row, column)])++ == 0;
}

std::string BinGrid::bin_name(std::size_t row, std::size_t column) const {
  return fmt::format("{}/{}, {}", name_, rows_.names.at(row), columns_.names.at(column));
}

nlohmann::ordered_json to_json(const std::vector<BinGrid>& grids) {
  auto json = nlohmann::ordered_json::array();
  for (const BinGrid& grid : grids) {
    auto counts = nlohmann::ordered_json::array();
    for (const auto& count : grid.counts_) counts.push_back(count ? nlohmann::ordered_json(*count) : nullptr);
    json.push_back({{"name", grid.name_},
                    {"text", grid.text_},
                    {"rows", {{"text", grid.rows_.text}, {"names", grid.rows_.names}}},
                    {"columns", {{"text", grid.columns_.text}, {"names", grid.columns_.names}}},
                    {"counts", counts}});
  }
  return json;
}

std::vector<BinGrid> read_bin_grids(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) bad_input(file.string(), "open", "nothing", "what feline_coverage run writes");
  std::vector<BinGrid> grids;
  try {
    const auto axis = [](const nlohmann::ordered_json& json) {
      return BinGrid::Axis{json.at("text").get<std::string>(), json.at("names").get<std::vector<std::string>>()};
    };
    for (const auto& json : nlohmann::ordered_json::parse(in)) {
      BinGrid grid(json.at("name").get<std::string>(), json.at("text").get<std::string>(), axis(json.at("rows")),
                   axis(json.at("columns")));
      const auto& counts = json.at("counts");
      if (counts.size() != grid.counts_.size()) {
        bad_input(file.string(), grid.name_ + ".counts", fmt::format("{}", counts.size()),
                  fmt::format("{}", grid.counts_.size()));
      }
      for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i].is_null()) {
          grid.counts_[i].reset();
        } else {
          grid.counts_[i] = whole_from_json<std::uint64_t>(counts[i]);
        }
      }
      grids.push_back(std::move(grid));
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    bad_input(file.string(), "JSON", error.what(), "what feline_coverage run writes");
  }
  return grids;
}

std::vector<Point> bin_points(const std::vector<BinGrid>& grids) {
  std::vector<Point> points;
  for (const BinGrid& grid : grids) {
    for (std::size_t row = 0; row < grid.rows().names.size(); ++row) {
      for (std::size_t column = 0; column < grid.columns().names.size(); ++column) {
        const auto count = grid.count_of(row, column);
        if (count) points.push_back({Kind::kBin, grid.bin_name(row, column), grid.name(), 0, *count});
      }
    }
  }
  return points;
}

std::vector<std::string> numbers(int first, int last) {
  std::vector<std::string> names;
  for (int value = first; value <= last; ++value) names.push_back(fmt::format("{}", value));
  return names;
}

std::vector<std::string> words(std::initializer_list<std::string_view> names) { return {names.begin(), names.end()}; }

}  // namespace feline::coverage
