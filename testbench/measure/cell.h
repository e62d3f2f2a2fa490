// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "testbench/measure/contestant.h"
#include "testbench/measure/detail.h"
#include "testbench/measure/errors.h"
#include "testbench/measure/exhibit.h"

namespace feline {

// Against one truth; means are over all frames.
struct CellErrors {
  Errors errors;
  double visible = 0;             // part of the pixels, of the first frame
  std::optional<double> shimmer;  // mean square, of a sequence
};

// One contestant on one exhibit: error and run time. Costs are means a pixel.
struct Cell {
  std::string exhibit;
  std::string contestant;
  CellErrors gaussian;
  CellErrors box;
  double nanoseconds = 0;
  reference::Cost cost;
  std::optional<double> rtl_cycles;
  // Of the exhibit's detail, PNG in base64: the picture, its difference from the Gaussian truth, the probes a pixel
  // (empty where they cannot be told).
  std::string detail_png;
  std::string difference_png;
  std::string probes_png;
};

nlohmann::ordered_json to_json(const Cell& cell);
Cell cell_from_json(const nlohmann::ordered_json& json);

// `truths`: one a frame. The worst error and the pictures of a sequence are those of a frame each.
Cell measure_cell(const Contestant& contestant, const Exhibit& exhibit, const std::vector<Truth>& truths,
                  const Detail& detail);

}  // namespace feline
