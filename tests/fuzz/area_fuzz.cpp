// SPDX-License-Identifier: Apache-2.0
// What Yosys says of a unit, and a Liberty file: areas are numbers, and the same again as JSON.
#include <cmath>

#include "testbench/area/area.h"
#include "tests/fuzz/fuzz.h"

void feline::fuzz::run(Input input) {
  const std::string_view words = input.part('\0');
  const std::string_view cells = input.part('\0');
  accepts<std::runtime_error>([&] {
    const AreaReport report{"yosys", "library", parse_area(words, cells, input.rest())};
    for (const StageArea& stage : report.stages) {
      require(stage.cells >= 0 && std::isfinite(stage.gates) && stage.gates >= 0, "parse_area: areas");
      require(stage.product_bits() >= 0, "parse_area: multipliers");
      require(stage_area_from_json(to_json(stage)) == stage, "to_json: the same again");
    }
    to_text(report);
  });
}
