// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "testbench/report/claims.h"
#include "testbench/report/csv.h"
#include "testbench/report/page.h"
#include "testbench/report/standing.h"

namespace feline {
namespace {

// Infinity has no JSON: a picture without error has no psnr.
nlohmann::ordered_json to_json(const CellErrors& errors) {
  nlohmann::ordered_json json{{"rmse", errors.errors.rmse()},
                              {"worst", errors.errors.worst},
                              {"worst_column", errors.errors.worst_column},
                              {"worst_row", errors.errors.worst_row},
                              {"worst_frame", errors.worst_frame},
                              {"butteraugli", errors.butteraugli}};
  if (std::isfinite(errors.errors.psnr())) json["psnr"] = errors.errors.psnr();
  if (errors.shimmer) json["shimmer"] = std::sqrt(*errors.shimmer);
  return json;
}

nlohmann::ordered_json row_to_json(const Cell& cell) {
  const bool told = find_contestant(cell.contestant)->kind != Contestant::Kind::kLibrary;
  nlohmann::ordered_json json{{"filter", cell.contestant},
                              {"gaussian", to_json(cell.gaussian)},
                              {"box", to_json(cell.box)},
                              {"nanoseconds", cell.nanoseconds}};
  if (told) {
    json["probes"] = cell.cost.probes;
    json["texels"] = cell.cost.texels;
    json["cycles"] = cell.cost.cycles;
    json["stamp_cycles"] = cell.cost.stamp_cycles;
  }
  if (cell.rtl_cycles) json["rtl_cycles"] = *cell.rtl_cycles;
  return json;
}

nlohmann::ordered_json rows_to_json(const std::vector<Cell>& cells) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Cell& cell : cells) {
    rows.push_back(row_to_json(cell));
    rows.back()["pareto"] = fronts_of(cells, cell);
  }
  return rows;
}

nlohmann::ordered_json to_json(const ExhibitResult& result) {
  nlohmann::ordered_json json{{"scene", result.plan.name},
                              {"width", result.plan.width},
                              {"height", result.plan.height},
                              {"frames", result.plan.frame_count}};
  if (result.truth) {
    json["truth"] = {{"samples", result.truth->samples},
                     {"projection", result.plan.perspective ? "exact" : "affine"},
                     {"gaussian_error", result.truth->gaussian_error},
                     {"box_error", result.truth->box_error}};
  }
  json["filters"] = rows_to_json(result.cells);
  json["unit_error"] = nlohmann::ordered_json::array();
  for (const Split& split : result.splits) {
    json["unit_error"].push_back({{"kernel", split.kernel},
                                  {"feline_rmse", std::sqrt(split.feline)},
                                  {"table_rmse", std::sqrt(split.table)},
                                  {"arithmetic_rmse", std::sqrt(split.arithmetic)}});
  }
  return json;
}

nlohmann::ordered_json to_json(const Claim& claim) {
  nlohmann::ordered_json json{{"claim", claim.name},
                              {"statement", claim.statement},
                              {"source", claim.source},
                              {"verdict", verdict_text(claim)},
                              {"measured", claim.measured}};
  if (claim.verdict == Verdict::kContradicted) json["reason"] = claim.reason;
  return json;
}

std::string to_text(const Survey& survey, const std::vector<Claim>& claims) {
  std::string text;
  for (const ExhibitResult& result : survey.results) {
    std::vector<const Cell*> sorted;
    for (const Cell& cell : result.cells) sorted.push_back(&cell);
    std::ranges::stable_sort(sorted, {}, [](const Cell* cell) { return cell->gaussian.errors.mean_square; });
    text += fmt::format("{:<44}{:>9}{:>9}", result.plan.name + ", PSNR against", "Gaussian", "box");
    for (const Currency& currency : kCurrencies) text += fmt::format("{:>12}", currency.title);
    text += "\n";
    for (const Cell* const cell : sorted) {
      text += fmt::format("  {:<42}{:>9.2f}{:>9.2f}", cell->contestant, cell->gaussian.errors.psnr(),
                          cell->box.errors.psnr());
      for (const Currency& currency : kCurrencies) {
        text += fmt::format("{:>12}", currency.counts(*cell) ? fmt::format("{:.1f}", currency.of(*cell)) : "");
      }
      text += "\n";
    }
  }
  for (const Claim& claim : claims) {
    if (claim.verdict == Verdict::kNotMeasured) continue;
    text += fmt::format("{:<32}{} ({})\n", verdict_text(claim), claim.name, claim.source);
  }
  if (survey.missing != 0) {
    text +=
        fmt::format("{} pieces were not begun within the budget: the same command goes on with them\n", survey.missing);
  }
  return text;
}

}  // namespace

Report make_report(const Survey& survey) {
  const std::vector<Claim> claims = judge_claims(survey);
  Report report;
  report.holds = std::ranges::none_of(
      claims, [](const Claim& claim) { return claim.ours && claim.verdict == Verdict::kContradicted; });
  const bool judged = std::ranges::any_of(
      claims, [](const Claim& claim) { return claim.ours && claim.verdict != Verdict::kNotMeasured; });
  report.json = {{"missing", survey.missing}};
  if (judged) report.json["holds"] = report.holds;
  for (const ExhibitResult& result : survey.results) report.json["scenes"].push_back(to_json(result));
  if (survey.results.size() > 1) report.json["all_scenes"] = rows_to_json(pool_exhibits(survey));
  for (const Claim& claim : claims) report.json["claims"].push_back(to_json(claim));
  report.csv = to_csv(survey);
  report.text = to_text(survey, claims);
  report.html = report_page(survey, claims);
  return report;
}

}  // namespace feline
