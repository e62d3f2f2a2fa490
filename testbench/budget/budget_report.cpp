// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/budget_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "testbench/csv_field.h"
#include "testbench/prune/prune.h"

namespace feline {
namespace {

std::string cost_name(CostKind kind) { return std::string(kCostNames[static_cast<std::size_t>(kind)]); }

// Infinity has no JSON: a picture without error has no psnr, and no loss.
void add_errors(nlohmann::ordered_json& json, const Errors& errors, const Errors& full) {
  if (std::isfinite(errors.psnr())) json["psnr"] = errors.psnr();
  if (std::isfinite(loss(errors, full))) json["loss_db"] = loss(errors, full);
  json["worst"] = 255 * errors.worst;
  json["worst_column"] = errors.worst_column;
  json["worst_row"] = errors.worst_row;
}

nlohmann::ordered_json measurement_json(const SceneSearch& search, const SearchOptions& options, std::size_t place) {
  const Measurement& measurement = search.measurements[place];
  const Candidate& candidate = measurement.candidate;
  nlohmann::ordered_json json{{"mode", kModeNames[static_cast<std::size_t>(candidate.mode)]},
                              {"kernel", kKernelNames[static_cast<std::size_t>(candidate.kernel)]},
                              {"parameters", kParameterSetNames[static_cast<std::size_t>(candidate.parameters)]},
                              {"max_probes", candidate.max_probes},
                              {"cycles", measurement.cycles}};
  // Cycles are there already.
  json[cost_name(options.cost)] = *search.costs[place];
  add_errors(json, errors_of(measurement, options.truth), errors_of(search.measurements[search.full], options.truth));
  json["configuration"] = config_to_json(measurement.hardware);
  return json;
}

}  // namespace

bool all_hold(const std::vector<SceneSearch>& searches) {
  return std::ranges::all_of(
      searches, [](const SceneSearch& search) { return std::ranges::all_of(search.choices, &BudgetChoice::holds); });
}

std::string cost_text(CostKind kind, double cost) {
  return kind == CostKind::kCycles ? fmt::format("{:.2f}", cost) : fmt::format("{:.0f}", cost);
}

std::string saved_text(double cost, double full_cost) {
  const double change = 100 * (cost / full_cost - 1);
  return std::abs(change) < 0.05 ? "0.0 %" : fmt::format("{:+.1f} %", change);
}

std::string budget_text(const std::vector<SceneSearch>& searches, const SearchOptions& options) {
  std::string text;
  for (const SceneSearch& search : searches) {
    const Errors& full = errors_of(search.measurements[search.full], options.truth);
    text += fmt::format("{}: {} candidates, PSNR {:.2f} dB and worst pixel {:.1f} of 255 of the full unit, {} {}\n",
                        search.plan.name, search.measurements.size(), full.psnr(), 255 * full.worst,
                        cost_text(options.cost, search.full_cost), cost_name(options.cost));
    for (const BudgetChoice& choice : search.choices) {
      if (!choice.chosen) {
        text += fmt::format("  {:<12} none holds\n", budget_name(choice.budget));
        continue;
      }
      const Measurement& chosen = search.measurements[*choice.chosen];
      const Errors& errors = errors_of(*choice.verified, options.truth);
      const double cost = *search.costs[*choice.chosen];
      text += fmt::format("  {:<12} {} {} ({}), {:+.3f} dB, worst pixel {:.1f}: {}; {}{}\n", budget_name(choice.budget),
                          cost_text(options.cost, cost), cost_name(options.cost), saved_text(cost, search.full_cost),
                          0 - loss(errors, full), 255 * errors.worst, sampler_name(chosen.candidate),
                          widths_name(chosen.candidate), choice.holds ? "" : "; DOES NOT HOLD");
    }
  }
  return text;
}

nlohmann::ordered_json budget_json(const std::vector<SceneSearch>& searches, const SearchOptions& options) {
  nlohmann::ordered_json json{{"holds", all_hold(searches)},
                              {"truth", kTruthChoiceNames[static_cast<std::size_t>(options.truth)]},
                              {"cost", cost_name(options.cost)},
                              {"space", kSpaceNames[static_cast<std::size_t>(options.survey.space)]},
                              {"seed", options.survey.seed}};
  for (const SceneSearch& search : searches) {
    nlohmann::ordered_json scene{{"scene", search.plan.name},
                                 {"width", search.plan.width},
                                 {"height", search.plan.height},
                                 {"frames", search.plan.frame_count},
                                 {"candidates", search.measurements.size()}};
    scene["full"] = measurement_json(search, options, search.full);
    scene["full"]["configuration"] = config_to_json(kDefaultConfig);
    scene["full"][cost_name(options.cost)] = search.full_cost;
    const Errors& full = errors_of(search.measurements[search.full], options.truth);
    for (const BudgetChoice& choice : search.choices) {
      nlohmann::ordered_json entry{
          {choice.budget.kind == Budget::Kind::kDecibels ? "budget_db" : "budget_worst", choice.budget.limit},
          {"holding", choice.holding},
          {"holds", choice.holds}};
      if (choice.chosen) {
        entry["choice"] = measurement_json(search, options, *choice.chosen);
        entry["saved"] = 1 - *search.costs[*choice.chosen] / search.full_cost;
        entry["verified"] = nlohmann::ordered_json::object();
        add_errors(entry["verified"], errors_of(*choice.verified, options.truth), full);
      }
      scene["budgets"].push_back(std::move(entry));
    }
    for (const std::size_t place : search.front) scene["front"].push_back(measurement_json(search, options, place));
    json["scenes"].push_back(std::move(scene));
  }
  return json;
}

std::string budget_csv(const std::vector<SceneSearch>& searches, const SearchOptions& options) {
  std::string csv =
      "scene,mode,kernel,parameters,max_probes,mantissa_bits,table_side,subtexel_bits,level_fraction_bits,weight_bits,"
      "psnr,loss_db,worst,cycles";
  const bool has_cost = options.cost != CostKind::kCycles;
  if (has_cost) csv += fmt::format(",{}", cost_name(options.cost));
  csv += ",front,budgets\n";
  for (const SceneSearch& search : searches) {
    const Errors& full = errors_of(search.measurements[search.full], options.truth);
    for (std::size_t i = 0; i < search.measurements.size(); ++i) {
      const Measurement& each = search.measurements[i];
      const Candidate& candidate = each.candidate;
      const Widths& widths = candidate.widths;
      const Errors& errors = errors_of(each, options.truth);
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}", csv_field(search.plan.name),
                         kModeNames[static_cast<std::size_t>(candidate.mode)],
                         kKernelNames[static_cast<std::size_t>(candidate.kernel)],
                         kParameterSetNames[static_cast<std::size_t>(candidate.parameters)], candidate.max_probes,
                         widths.mantissa_bits, widths.table_side, widths.subtexel_bits, widths.level_fraction_bits,
                         widths.weight_bits, csv_field(errors.psnr()), csv_field(loss(errors, full)),
                         csv_field(255 * errors.worst), each.cycles);
      if (has_cost) csv += fmt::format(",{}", search.costs[i] ? csv_field(*search.costs[i]) : "");
      std::string budgets;
      for (const BudgetChoice& choice : search.choices) {
        if (choice.chosen == i) budgets += fmt::format("{}{}", budgets.empty() ? "" : "; ", budget_name(choice.budget));
      }
      csv += fmt::format(",{},{}\n", std::ranges::find(search.front, i) != search.front.end() ? 1 : 0, budgets);
    }
  }
  return csv;
}

}  // namespace feline
