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

// Against one truth; the mean square is over all frames.
struct CellErrors {
  Errors errors;
  int worst_frame = 0;            // of a sequence: that of the worst error
  std::optional<double> shimmer;  // mean square, of a sequence
  double butteraugli = 0;         // perceptual_distance in the part that is looked at closely, mean over frames
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
  // (empty where there is never more than one, or they cannot be told).
  std::string detail_png;
  std::string difference_png;
  std::string probes_png;
};

nlohmann::ordered_json to_json(const Cell& cell);
Cell cell_from_json(const nlohmann::ordered_json& json);

// Where an exhibit is looked at closely, both in the first frame.
struct Focus {
  Detail detail;   // shown enlarged
  Detail quarter;  // a quarter of the picture, for the perceptual measure, which takes long
};

// `truths`: one a frame. Of a sequence, the worst error is that of its worst frame.
Cell measure_cell(const Contestant& contestant, const Exhibit& exhibit, const std::vector<Truth>& truths,
                  const Focus& focus);

}  // namespace feline
