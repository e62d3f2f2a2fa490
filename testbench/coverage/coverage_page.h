// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/coverage/bin_grid.h"
#include "testbench/coverage/exclusions.h"
#include "testbench/coverage/ratchet.h"

namespace feline::coverage {

// All that one run reached.
struct Coverage {
  std::vector<Point> points;  // of every kind, exclusions applied
  std::vector<BinGrid> grids;
  std::vector<Exclusion> exclusions;
  std::vector<std::string> faults;  // of exclusions, and what was lost
};

std::string coverage_text(const Coverage& coverage);
nlohmann::ordered_json coverage_json(const Coverage& coverage);
std::string coverage_page(const Coverage& coverage, SourceText& sources);

}  // namespace feline::coverage
