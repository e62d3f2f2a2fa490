// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "testbench/budget/budget_report.h"
#include "testbench/page/html.h"
#include "testbench/page/plot.h"

namespace feline {
namespace {

std::string cost_label(CostKind kind) {
  switch (kind) {
    case CostKind::kCycles: return "cycles a pixel, a probe each";
    case CostKind::kGates: return "gates of the unit, NAND2 equivalents";
    case CostKind::kNanoseconds: return "nanoseconds a pixel of the model, one thread";
  }
  return {};
}

std::string_view truth_name(TruthChoice truth) { return truth == TruthChoice::kGaussian ? "Gaussian" : "box"; }

std::string_view cost_meaning(CostKind kind) {
  switch (kind) {
    case CostKind::kCycles:
      return "Cycles: the probes of a pixel, one a cycle, of hardware that reads eight texels a cycle. They do not "
             "tell widths apart: of equal costs the choice is the plainest mode, then the narrowest unit.";
    case CostKind::kGates:
      return "Gates: NAND2 equivalents of the synthesised unit; its ROMs are logic among them, the texel cache's "
             "memories are not. Synthesis is slow: of the candidates that hold a budget only those are synthesised "
             "than which no other one needs less, in every width and feature. It is assumed that a unit that needs no "
             "more than another one has no more gates. The plot shows what was synthesised.";
    case CostKind::kNanoseconds:
      return "Nanoseconds: processor time of one thread of the bit-accurate C++ model on this machine, the median of "
             "three runs. They are noisy, do not follow the widths, and say nothing of hardware.";
  }
  return {};
}

std::string introduction(const SearchOptions& options) {
  std::string html = page::paragraph(
      "Which is the cheapest way to texture a scene, if its picture may be a little worse than the full unit's? Every "
      "candidate of the space was rendered by its bit-accurate model and compared with the truth.");
  const auto kernel = kKernelNames[static_cast<std::size_t>(options.kernel)];
  const std::string_view truth = truth_name(options.truth);
  html += page::bullets(std::array<std::string, 5>{
      fmt::format("A budget in dB is the PSNR that may be lost against the full unit in Table mode with the exact "
                  "parameters and the {} kernel; a worst pixel is an error in codes of 255. Both are measured against "
                  "the {} truth, in linear light, without the outermost pixels.",
                  kernel, truth),
      std::string(cost_meaning(options.cost)),
      fmt::format("The space ({}): all modes; kernel where texels are interpolated; parameters in Simple and Table; at "
                  "most {} probes; mantissas of {} bits, an ellipse table of {} cells a side, sub-texels of {} bits, "
                  "levels with {} fraction bits, weights with {}; what makes no difference to a mode is at its least. "
                  "The small space has the widest and the narrowest unit, and fewer parameters and probes.",
                  kSpaceNames[static_cast<std::size_t>(options.survey.space)], "1, 2, 3, 4, 6, 8, 12 or 16",
                  fmt::join(Widths::kMantissaBits, ", "), fmt::join(Widths::kTableSides, " or "),
                  fmt::join(Widths::kSubtexelBits, " or "), fmt::join(Widths::kLevelFractionBits, " or "),
                  fmt::join(Widths::kWeightBits, " or ")),
      "The unit of a candidate has its widths and, beyond them, only what its sampler and the scene's lookups need: "
      "wraps, formats, sizes, levels, exponents. Its ROMs are whole; feline prune leaves out words of them, too.",
      "The choice was measured anew, and the whole space looked through for one that holds the budget at less cost."});
  return html;
}

page::Point point_of(const SceneSearch& search, const SearchOptions& options, std::size_t place) {
  return {*search.costs[place], errors_of(search.measurements[place], options.truth).psnr()};
}

// A user's own file may be called anything.
std::string identifier(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; }, '-');
  return name;
}

// The choices of budgets, named; budgets whose choices lie closer together than names have room share a name.
page::Series choice_points(const SceneSearch& search, const SearchOptions& options, double room_x, double room_y) {
  page::Series choices{"choices", {}, page::Style::kPoints};
  for (const BudgetChoice& choice : search.choices) {
    if (!choice.chosen) continue;
    page::Point point = point_of(search, options, *choice.chosen);
    const auto near = std::ranges::find_if(choices.points, [&](const page::Point& other) {
      return !other.label.empty() && std::abs(other.x - point.x) < room_x && std::abs(other.y - point.y) < room_y;
    });
    if (near == choices.points.end()) {
      point.label = budget_name(choice.budget);
    } else {
      near->label += ", " + budget_name(choice.budget);
    }
    choices.points.push_back(std::move(point));
  }
  return choices;
}

// Of the candidates whose PSNR is at least `least`.
std::string front_plot(const SceneSearch& search, const SearchOptions& options, std::string_view part, double least) {
  page::Plot plot;
  plot.name = identifier(fmt::format("{}-{}", search.plan.name, part));
  plot.title = fmt::format("{}, {}", search.plan.name, part);
  plot.x.label = cost_label(options.cost);
  plot.y.label = fmt::format("PSNR, dB, {} truth", truth_name(options.truth));
  page::Series candidates{"candidates", {}, page::Style::kPoints};
  page::Series front{"Pareto front", {}, page::Style::kLinesPoints};
  page::Series full{"full unit", {}, page::Style::kPoints};
  full.points.push_back({search.full_cost, errors_of(search.measurements[search.full], options.truth).psnr()});
  page::Point low = full.points.front();
  page::Point high = low;
  const auto add = [&](page::Series& series, std::size_t place) {
    const page::Point point = point_of(search, options, place);
    if (point.y < least || !std::isfinite(point.y)) return;
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    series.points.push_back(point);
  };
  for (std::size_t i = 0; i < search.measurements.size(); ++i) {
    if (search.costs[i]) add(candidates, i);
  }
  for (const std::size_t i : search.front) add(front, i);
  const double width = std::max(high.x - low.x, 0.01);
  const double height = std::max(high.y - low.y, 0.01);
  // Room for the names beside the dearest.
  plot.x.low = low.x - 0.05 * width;
  plot.x.high = high.x + 0.25 * width;
  plot.y.low = low.y - 0.05 * height;
  plot.y.high = high.y + 0.1 * height;
  plot.series = {std::move(candidates), std::move(front), std::move(full),
                 choice_points(search, options, 0.12 * width, 0.06 * height)};
  return page::svg(plot);
}

// All of the space, and closely what lies within twice the greatest budget in dB.
std::string front_plots(const SceneSearch& search, const SearchOptions& options) {
  constexpr double kGreatestShown = 3;
  double greatest = 0;
  for (const Budget& budget : options.budgets) {
    if (budget.kind == Budget::Kind::kDecibels && budget.limit <= kGreatestShown) {
      greatest = std::max(greatest, budget.limit);
    }
  }
  const std::string_view which =
      options.cost == CostKind::kGates ? "every candidate that was synthesised" : "every candidate";
  std::vector<std::string> plots{
      page::figure(front_plot(search, options, "all", -std::numeric_limits<double>::infinity()),
                   fmt::format("Error over {}: {}, and the choice for each budget.", cost_label(options.cost), which))};
  const double full = errors_of(search.measurements[search.full], options.truth).psnr();
  if (greatest > 0 && std::isfinite(full)) {
    plots.push_back(page::figure(front_plot(search, options, "close", full - 2 * greatest),
                                 fmt::format("The same, of those that lose at most {} dB.", 2 * greatest)));
  }
  return page::gallery(plots);
}

page::Table choice_table(const SceneSearch& search, const SearchOptions& options) {
  page::Table table;
  const std::string unit(kCostNames[static_cast<std::size_t>(options.cost)]);
  table.columns = {{"budget"},     {"choice"},     {"widths, bits"},       {unit, true},      {"saved", true},
                   {"PSNR", true}, {"loss", true}, {"worst of 255", true}, {"holding", true}, {"verified"}};
  const Errors& full = errors_of(search.measurements[search.full], options.truth);
  const Candidate& whole = search.measurements[search.full].candidate;
  table.rows.push_back({{"full unit"},
                        {sampler_name(whole)},
                        {widths_name(whole)},
                        {cost_text(options.cost, search.full_cost)},
                        {""},
                        {fmt::format("{:.2f}", full.psnr())},
                        {""},
                        {fmt::format("{:.1f}", 255 * full.worst)},
                        {fmt::format("of {}", search.measurements.size())},
                        {""}});
  for (const BudgetChoice& choice : search.choices) {
    if (!choice.chosen) {
      table.rows.push_back({{budget_name(choice.budget)},
                            {"none holds", page::Tone::kBad},
                            {""},
                            {""},
                            {""},
                            {""},
                            {""},
                            {""},
                            {"0"},
                            {""}});
      continue;
    }
    const Candidate& candidate = search.measurements[*choice.chosen].candidate;
    const Errors& errors = errors_of(*choice.verified, options.truth);
    const double cost = *search.costs[*choice.chosen];
    table.rows.push_back(
        {{budget_name(choice.budget)},
         {sampler_name(candidate)},
         {widths_name(candidate)},
         {cost_text(options.cost, cost)},
         {saved_text(cost, search.full_cost)},
         {fmt::format("{:.2f}", errors.psnr())},
         {fmt::format("{:+.3f}", loss(errors, full))},
         {fmt::format("{:.1f}", 255 * errors.worst)},
         {std::to_string(choice.holding)},
         {choice.holds ? "holds" : "does not hold", choice.holds ? page::Tone::kGood : page::Tone::kBad}});
  }
  return table;
}

page::Table front_table(const SceneSearch& search, const SearchOptions& options) {
  page::Table table;
  table.columns = {{"candidate"},
                   {"widths, bits"},
                   {std::string(kCostNames[static_cast<std::size_t>(options.cost)]), true},
                   {"PSNR", true},
                   {"worst of 255", true}};
  for (const std::size_t i : search.front) {
    const Measurement& each = search.measurements[i];
    const Errors& errors = errors_of(each, options.truth);
    table.rows.push_back({{sampler_name(each.candidate)},
                          {widths_name(each.candidate)},
                          {cost_text(options.cost, *search.costs[i])},
                          {fmt::format("{:.2f}", errors.psnr())},
                          {fmt::format("{:.1f}", 255 * errors.worst)}});
  }
  return table;
}

}  // namespace

std::string budget_page(const std::vector<SceneSearch>& searches, const SearchOptions& options) {
  std::string html = introduction(options);
  for (const SceneSearch& search : searches) {
    html += page::heading(2, search.plan.name);
    html += page::paragraph(
        fmt::format("{}; {} x {}{}.", search.plan.description, search.plan.width, search.plan.height,
                    search.plan.frame_count > 1 ? fmt::format(", {} frames", search.plan.frame_count) : std::string()));
    html += page::table(choice_table(search, options));
    html += front_plots(search, options);
    html +=
        page::fold(fmt::format("The {} on the front", search.front.size()), page::table(front_table(search, options)));
  }
  return page::document("Pruning to an error budget", html);
}

}  // namespace feline
