// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "testbench/coverage/point.h"

namespace feline::coverage {

// Of one kind, excluded points apart.
struct Figure {
  std::uint64_t hit = 0;
  std::uint64_t total = 0;
  std::uint64_t excluded = 0;
  bool operator==(const Figure&) const = default;
};
using Figures = std::array<Figure, kKindCount>;
Figures figures_of(const std::vector<Point>& points);

// What was reached when the ratchet was written: figures, and the names of the points that were not reached.
struct Ratchet {
  Figures figures{};
  std::array<std::vector<std::string>, kKindCount> missing{};
  bool operator==(const Ratchet&) const = default;
};
Ratchet ratchet_of(const std::vector<Point>& points);

nlohmann::ordered_json to_json(const Ratchet& ratchet);
// Throws InputError naming the file, the field and what is wrong with it.
Ratchet read_ratchet(const std::filesystem::path& file);

// What was lost since, a line each: every point that is not reached now and was, or was not there; every figure that
// is lower. Nothing where all is as it was or better.
std::vector<std::string> losses(const std::vector<Point>& points, const Ratchet& before);

// "100 %" for all of them only: shares are rounded down to a hundredth.
std::string share_text(const Figure& figure);

}  // namespace feline::coverage
