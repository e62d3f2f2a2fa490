// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>

#include "testbench/csv_field.h"
#include "testbench/report/standing.h"

namespace feline {
namespace {

std::string told(const Cell& cell, double cost) {
  return find_contestant(cell.contestant)->kind == Contestant::Kind::kLibrary ? "" : csv_field(cost);
}

std::string shimmer(const CellErrors& errors) { return errors.shimmer ? csv_field(std::sqrt(*errors.shimmer)) : ""; }

struct Column {
  std::string_view name;
  std::string (*of)(const Cell& cell);
};
constexpr std::array kColumns{
    Column{"filter", [](const Cell& cell) { return cell.contestant; }},
    Column{"rmse_gaussian", [](const Cell& cell) { return csv_field(cell.gaussian.errors.rmse()); }},
    Column{"psnr_gaussian", [](const Cell& cell) { return csv_field(cell.gaussian.errors.psnr()); }},
    Column{"worst_gaussian", [](const Cell& cell) { return csv_field(cell.gaussian.errors.worst); }},
    Column{"butteraugli_gaussian", [](const Cell& cell) { return csv_field(cell.gaussian.butteraugli); }},
    Column{"shimmer_gaussian", [](const Cell& cell) { return shimmer(cell.gaussian); }},
    Column{"rmse_box", [](const Cell& cell) { return csv_field(cell.box.errors.rmse()); }},
    Column{"psnr_box", [](const Cell& cell) { return csv_field(cell.box.errors.psnr()); }},
    Column{"worst_box", [](const Cell& cell) { return csv_field(cell.box.errors.worst); }},
    Column{"butteraugli_box", [](const Cell& cell) { return csv_field(cell.box.butteraugli); }},
    Column{"shimmer_box", [](const Cell& cell) { return shimmer(cell.box); }},
    Column{"nanoseconds", [](const Cell& cell) { return csv_field(cell.nanoseconds); }},
    Column{"probes", [](const Cell& cell) { return told(cell, cell.cost.probes); }},
    Column{"texels", [](const Cell& cell) { return told(cell, cell.cost.texels); }},
    Column{"cycles", [](const Cell& cell) { return told(cell, cell.cost.cycles); }},
    Column{"stamp_cycles", [](const Cell& cell) { return told(cell, cell.cost.stamp_cycles); }},
    Column{"rtl_cycles", [](const Cell& cell) { return cell.rtl_cycles ? csv_field(*cell.rtl_cycles) : ""; }},
};

void add_rows(std::string& csv, const std::string& scene, const std::vector<Cell>& cells) {
  for (const Cell& cell : cells) {
    csv += csv_field(scene);
    for (const Column& column : kColumns) csv += fmt::format(",{}", column.of(cell));
    csv += fmt::format(",{}\n", fmt::join(fronts_of(cells, cell), " "));
  }
}

}  // namespace

std::string to_csv(const Survey& survey) {
  std::string csv = "scene";
  for (const Column& column : kColumns) csv += fmt::format(",{}", column.name);
  csv += ",pareto\n";
  for (const ExhibitResult& result : survey.results) add_rows(csv, result.plan.name, result.cells);
  if (survey.results.size() > 1) add_rows(csv, "all", pool_exhibits(survey));
  return csv;
}

}  // namespace feline
