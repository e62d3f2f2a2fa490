// SPDX-License-Identifier: Apache-2.0
#include "testbench/area/area.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "testbench/json_input.h"

namespace feline {
namespace {

constexpr std::array<std::string_view, 10> kOrder{"group",   "footprint", "plan",   "walk",       "spill",
                                                  "address", "fetch",     "filter", "accumulate", "rest"};

// "\stage_plan" to "plan"; the unit itself holds what is no stage.
std::string stage_of(std::string_view module) {
  if (module.starts_with('\\')) module.remove_prefix(1);
  // A module of a chosen parameter: "$paramod\feline_spill_register\Width=...".
  if (module.find("feline_spill_register") != std::string_view::npos) return "spill";
  for (const std::string_view prefix : {"stage_", "feline_"}) {
    if (module.starts_with(prefix)) module.remove_prefix(prefix.size());
  }
  return module == "unit" ? "rest" : std::string(module);
}

StageArea& stage_in(std::vector<StageArea>& stages, std::string_view module) {
  const std::string name = stage_of(module);
  const auto found = std::ranges::find(stages, name, &StageArea::stage);
  if (found != stages.end()) return *found;
  if (std::ranges::find(kOrder, name) == kOrder.end()) throw std::runtime_error("no stage of the unit: " + name);
  stages.emplace_back().stage = name;
  return stages.back();
}

void add(std::vector<Multipliers>& all, const Multipliers& more) {
  const auto same = std::ranges::find_if(all, [&](const Multipliers& each) {
    return each.left_bits == more.left_bits && each.right_bits == more.right_bits;
  });
  if (same == all.end()) {
    all.push_back(more);
  } else {
    same->count += more.count;
  }
}

std::int64_t count_in(const nlohmann::json& json) {
  // Sums of products of two stay far below 2^63.
  constexpr std::int64_t kMost = std::int64_t{1} << 24;
  const auto count = whole_from_json<std::int64_t>(json);
  if (count < 0 || count > kMost) throw std::runtime_error(fmt::format("not what Yosys writes: a count of {}", count));
  return count;
}

// A bit is the number of its net, or "0", "1", "x".
bool is_constant(const nlohmann::json& bits) {
  return std::ranges::all_of(bits, [](const nlohmann::json& bit) { return bit.is_string(); });
}

void add_word_cell(StageArea& stage, const nlohmann::json& cell) {
  const nlohmann::json& parameters = cell.at("parameters");
  const auto value = [&](const char* name) { return count_in(parameters.at(name)); };
  if (cell.at("type") == "$mul") {
    const nlohmann::json& connections = cell.at("connections");
    if (is_constant(connections.at("A")) || is_constant(connections.at("B"))) return;
    const auto [right, left] = std::minmax({static_cast<int>(value("A_WIDTH")), static_cast<int>(value("B_WIDTH"))});
    add(stage.multipliers, {left, right, 1});
  } else {
    (value("WR_PORTS") == 0 ? stage.rom_bits : stage.memory_bits) += value("SIZE") * value("WIDTH");
  }
}

}  // namespace

int StageArea::multiplier_count() const {
  int count = 0;
  for (const Multipliers& each : multipliers) count += each.count;
  return count;
}

std::int64_t StageArea::product_bits() const {
  std::int64_t bits = 0;
  for (const Multipliers& each : multipliers) bits += std::int64_t{each.left_bits} * each.right_bits * each.count;
  return bits;
}

StageArea AreaReport::total() const {
  StageArea total;
  total.stage = "all";
  for (const StageArea& stage : stages) {
    total.cells += stage.cells;
    total.gates += stage.gates;
    total.flip_flops += stage.flip_flops;
    total.rom_bits += stage.rom_bits;
    total.memory_bits += stage.memory_bits;
    for (const Multipliers& each : stage.multipliers) add(total.multipliers, each);
  }
  return total;
}

std::vector<StageArea> parse_area(std::string_view words, std::string_view cells, std::string_view library) {
  std::vector<StageArea> stages;
  const double nand = cell_area(library, "NAND2X1");
  try {
    const nlohmann::json mapped = nlohmann::json::parse(cells);
    for (const auto& [name, module] : mapped.at("modules").items()) {
      StageArea& stage = stage_in(stages, name);
      for (const auto& [type, count] : module.at("num_cells_by_type").items()) {
        // Memories begin with $; stages are within the unit and count for themselves.
        if (type.starts_with('$') || type.starts_with("stage_")) continue;
        const std::int64_t cells_of_type = count_in(count);
        stage.cells += cells_of_type;
        stage.gates += static_cast<double>(cells_of_type) * cell_area(library, type) / nand;
        if (type.starts_with("DFF")) stage.flip_flops += cells_of_type;
      }
    }
    const nlohmann::json netlist = nlohmann::json::parse(words);
    for (const auto& [name, module] : netlist.at("modules").items()) {
      for (const auto& cell : module.at("cells")) add_word_cell(stage_in(stages, name), cell);
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("not what Yosys writes: {}", error.what()));
  }
  std::ranges::sort(stages, {}, [](const StageArea& stage) { return std::ranges::find(kOrder, stage.stage); });
  for (StageArea& stage : stages) {
    std::ranges::sort(stage.multipliers, std::ranges::greater{},
                      [](const Multipliers& each) { return std::pair(each.left_bits, each.right_bits); });
  }
  return stages;
}

double cell_area(std::string_view library, std::string_view cell) {
  constexpr std::string_view kArea = "area :";
  const std::size_t start = library.find(fmt::format("cell ({})", cell));
  double area = 0;
  if (start != std::string_view::npos) {
    const std::string_view own = library.substr(start, library.find("cell (", start + 1) - start);
    const std::size_t at = own.find(kArea);
    constexpr std::size_t kEnough = 32;
    if (at != std::string_view::npos) {
      area = std::strtod(std::string(own.substr(at + kArea.size(), kEnough)).c_str(), nullptr);
    }
  }
  if (!(area > 0 && std::isfinite(area))) throw std::runtime_error(fmt::format("no area of a cell {}", cell));
  return area;
}

nlohmann::ordered_json to_json(const StageArea& stage) {
  nlohmann::ordered_json multipliers = nlohmann::ordered_json::array();
  for (const Multipliers& each : stage.multipliers) {
    multipliers.push_back({{"left_bits", each.left_bits}, {"right_bits", each.right_bits}, {"count", each.count}});
  }
  return {{"stage", stage.stage},
          {"cells", stage.cells},
          {"gate_equivalents", stage.gates},
          {"flip_flops", stage.flip_flops},
          {"multiplier_count", stage.multiplier_count()},
          {"product_bits", stage.product_bits()},
          {"multipliers", multipliers},
          {"rom_bits", stage.rom_bits},
          {"memory_bits", stage.memory_bits}};
}

StageArea stage_area_from_json(const nlohmann::ordered_json& json) {
  StageArea stage;
  json.at("stage").get_to(stage.stage);
  stage.cells = whole_from_json<std::int64_t>(json.at("cells"));
  json.at("gate_equivalents").get_to(stage.gates);
  stage.flip_flops = whole_from_json<std::int64_t>(json.at("flip_flops"));
  stage.rom_bits = whole_from_json<std::int64_t>(json.at("rom_bits"));
  stage.memory_bits = whole_from_json<std::int64_t>(json.at("memory_bits"));
  for (const auto& each : json.at("multipliers")) {
    stage.multipliers.push_back({whole_from_json<std::int16_t>(each.at("left_bits")),
                                 whole_from_json<std::int16_t>(each.at("right_bits")),
                                 whole_from_json<std::int16_t>(each.at("count"))});
  }
  return stage;
}

nlohmann::ordered_json to_json(const AreaReport& report) {
  nlohmann::ordered_json json{{"synthesizer", report.synthesizer}, {"library", report.library}};
  for (const StageArea& stage : report.stages) json["stages"].push_back(to_json(stage));
  json["total"] = to_json(report.total());
  return json;
}

std::string to_text(const AreaReport& report) {
  std::string text = fmt::format("{:<11}{:>8}{:>9}{:>11}{:>12}{:>13}{:>9}{:>12}\n", "stage", "cells", "NAND2",
                                 "flip-flops", "multipliers", "product bits", "ROM bits", "memory bits");
  const auto line = [&](const StageArea& stage) {
    text += fmt::format("{:<11}{:>8}{:>9.0f}{:>11}{:>12}{:>13}{:>9}{:>12}\n", stage.stage, stage.cells, stage.gates,
                        stage.flip_flops, stage.multiplier_count(), stage.product_bits(), stage.rom_bits,
                        stage.memory_bits);
  };
  for (const StageArea& stage : report.stages) line(stage);
  if (report.stages.size() > 1) line(report.total());
  return text + fmt::format("{}; {}\n", report.synthesizer, report.library);
}

}  // namespace feline
