// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tables/config.h"
#include "testbench/area/area.h"
#include "testbench/measure/errors.h"
#include "testbench/prune/check.h"

namespace feline {

// What the unit of one scene saves, and that it loses nothing.
struct Savings {
  std::string scene;
  int width = 0;  // of a frame
  int height = 0;
  int frames = 1;
  Config config;
  PrunedCheck check;  // of every pixel
  Errors gaussian;    // of the picture, the full unit's too, against each truth
  Errors box;
  StageArea full;  // all stages
  StageArea pruned;

  // Every pixel is the full unit's, and RTL and model agree.
  bool holds() const { return check.holds() && check.identical == check.lookups; }
};

// The table of all scenes: JSON, RFC 4180, and the Markdown that is read.
nlohmann::ordered_json savings_json(const std::vector<Savings>& all);
std::string savings_csv(const std::vector<Savings>& all);
std::string savings_markdown(const std::vector<Savings>& all);

}  // namespace feline
