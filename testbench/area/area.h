// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace feline {

// Multipliers of two operands that are no constants, left_bits x right_bits, as wide as what reaches them.
struct Multipliers {
  int left_bits = 0;
  int right_bits = 0;
  int count = 0;

  bool operator==(const Multipliers&) const = default;
};

// What one stage takes in standard cells. ROMs are logic, and in cells and gates; memories, of which the texel cache
// has four, are macros, and in memory_bits only.
struct StageArea {
  std::string stage;  // "spill" between walk and address; "rest" for what belongs to no stage
  std::int64_t cells = 0;
  double gates = 0;  // area in NAND2X1, gate equivalents
  std::int64_t flip_flops = 0;
  std::int64_t rom_bits = 0;  // of every copy
  std::int64_t memory_bits = 0;
  std::vector<Multipliers> multipliers;

  int multiplier_count() const;
  std::int64_t product_bits() const;  // of all multipliers, left_bits * right_bits

  bool operator==(const StageArea&) const = default;
};

struct AreaReport {
  std::string synthesizer;  // name and version
  std::string library;      // of cells
  std::vector<StageArea> stages;

  // The stages' sum, as stage "all".
  StageArea total() const;
};

// What Yosys says of its modules, "feline_<stage>" or "stage_<stage>": `words` is the netlist of the multipliers and
// memories before they are mapped (json -compat-int), `cells` the statistics after it (stat -json), `library` the text
// of the Liberty file with the cells' areas. Stages in the order of the unit. Throws std::runtime_error when it is no
// such text.
std::vector<StageArea> parse_area(std::string_view words, std::string_view cells, std::string_view library);

// The area of one cell in a Liberty library's text. Throws std::runtime_error when there is none.
double cell_area(std::string_view library, std::string_view cell);

nlohmann::ordered_json to_json(const StageArea& stage);
StageArea stage_area_from_json(const nlohmann::ordered_json& json);
nlohmann::ordered_json to_json(const AreaReport& report);
std::string to_text(const AreaReport& report);

}  // namespace feline
