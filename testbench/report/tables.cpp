// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "testbench/page/plot.h"

namespace feline {
namespace {

// A filter's name without what every Feline row repeats.
std::string short_name(std::string name) {
  const auto replace = [&](std::string_view from, std::string_view to) {
    if (const auto at = name.find(from); at != std::string::npos) name.replace(at, from.size(), to);
  };
  replace("_high_quality", " HQ");
  replace("_high_efficiency", " HE");
  replace("_gaussian", " g");
  replace("feline_", "");
  return name;
}

// Those of a front whose names do not run into each other, from its dear end, where the best filters are.
std::vector<const Cell*> names_apart(const std::vector<const Cell*>& front, const Currency& currency,
                                     const TruthKind& truth) {
  constexpr double kLine = 2.5;   // decibels a line of text, on an axis of about 50
  constexpr double kWidth = 1.2;  // decades that a name is wide
  std::vector<const Cell*> named;
  for (std::size_t i = front.size(); i-- > 0;) {
    const auto runs_into = [&](const Cell* other) {
      return std::abs(std::log10(currency.of(*other) / currency.of(*front[i]))) < kWidth &&
             std::abs((other->*truth.errors).errors.psnr() - (front[i]->*truth.errors).errors.psnr()) < kLine;
    };
    if (std::ranges::none_of(named, runs_into)) named.push_back(front[i]);
  }
  return named;
}

// A user's own file may be called anything.
std::string identifier(std::string name) {
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; }, '-');
  return name;
}

// From a power of ten to where the names of the dearest have room.
void fit_costs(page::Axis& axis, const std::vector<Cell>& cells, const Currency& currency) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const Cell& cell : cells) {
    const double cost = currency.counts(cell) ? currency.of(cell) : 0;
    if (!(cost > 0)) continue;
    low = std::min(low, cost);
    high = std::max(high, cost);
  }
  if (high == 0) return;
  axis.low = std::pow(10, std::floor(std::log10(low)));
  axis.high = 4 * high;
}

page::Cell plain(std::string text) { return {std::move(text)}; }

page::Cell cost(const Cell& cell, const Currency& currency, const std::array<std::vector<const Cell*>, 2>& fronts) {
  if (!currency.counts(cell)) return plain("");
  const bool best = on_front(fronts[0], cell) || on_front(fronts[1], cell);
  const double value = currency.of(cell);
  return {value < 10    ? fmt::format("{:.2f}", value)
          : value < 100 ? fmt::format("{:.1f}", value)
                        : fmt::format("{:.0f}", value),
          best ? page::Tone::kGood : page::Tone::kPlain};
}

}  // namespace

std::string decibels(double psnr) { return std::isfinite(psnr) ? fmt::format("{:.2f}", psnr) : "equal"; }

page::Table standing_table(const std::vector<Cell>& cells) {
  page::Table table;
  table.columns = {{"filter"},      {"PSNR, Gaussian", true}, {"PSNR, box", true}, {"RMSE x 1000", true},
                   {"worst", true}, {"Butteraugli", true},    {"probes", true}};
  for (const Currency& currency : kCurrencies) table.columns.push_back({std::string(currency.title), true});
  const bool moves = std::ranges::any_of(cells, [](const Cell& cell) { return cell.gaussian.shimmer.has_value(); });
  if (moves) table.columns.push_back({"shimmer x 1000", true});
  std::array<std::array<std::vector<const Cell*>, 2>, kCurrencies.size()> fronts;
  for (std::size_t i = 0; i < kCurrencies.size(); ++i) {
    for (std::size_t j = 0; j < kTruthKinds.size(); ++j) {
      fronts[i][j] = pareto_front(cells, kCurrencies[i], kTruthKinds[j]);
    }
  }
  std::vector<const Cell*> sorted;
  for (const Cell& cell : cells) sorted.push_back(&cell);
  std::ranges::stable_sort(sorted, [](const Cell* a, const Cell* b) {
    return a->gaussian.errors.mean_square < b->gaussian.errors.mean_square;
  });
  for (const Cell* const cell : sorted) {
    const bool known = find_contestant(cell->contestant)->kind != Contestant::Kind::kLibrary;
    table.rows.push_back({plain(cell->contestant), plain(decibels(cell->gaussian.errors.psnr())),
                          plain(decibels(cell->box.errors.psnr())),
                          plain(fmt::format("{:.2f}", 1000 * cell->gaussian.errors.rmse())),
                          plain(fmt::format("{:.3f}", cell->gaussian.errors.worst)),
                          plain(fmt::format("{:.2f}", cell->gaussian.butteraugli)),
                          plain(known ? fmt::format("{:.2f}", cell->cost.probes) : "")});
    for (std::size_t i = 0; i < kCurrencies.size(); ++i) {
      table.rows.back().push_back(cost(*cell, kCurrencies[i], fronts[i]));
    }
    if (moves)
      table.rows.back().push_back(plain(fmt::format("{:.2f}", 1000 * std::sqrt(cell->gaussian.shimmer.value_or(0)))));
  }
  return table;
}

std::string standing_plot(const std::string& name, const std::string& title, const std::vector<Cell>& cells,
                          const Currency& currency, const TruthKind& truth) {
  page::Plot plot;
  plot.name = identifier(name);
  plot.title = title;
  plot.x.label = currency.label;
  plot.x.log = true;
  plot.y.label = "PSNR, dB";
  fit_costs(plot.x, cells, currency);
  page::Series front{"Pareto front", {}, page::Style::kLines};
  page::Series papers{"papers, double", {}, page::Style::kPoints};
  page::Series unit{"the 8-bit unit", {}, page::Style::kPoints};
  page::Series library{"OpenImageIO", {}, page::Style::kPoints};
  const auto best = pareto_front(cells, currency, truth);
  const auto named = names_apart(best, currency, truth);
  const auto point_of = [&](const Cell& cell) {
    return page::Point{currency.of(cell), (cell.*truth.errors).errors.psnr(),
                       on_front(named, cell) ? short_name(cell.contestant) : ""};
  };
  for (const Cell* const cell : best) front.points.push_back({currency.of(*cell), (cell->*truth.errors).errors.psnr()});
  for (const Cell& cell : cells) {
    if (!currency.counts(cell)) continue;
    const Contestant::Kind kind = find_contestant(cell.contestant)->kind;
    page::Series& series = kind == Contestant::Kind::kReference ? papers
                           : kind == Contestant::Kind::kUnit    ? unit
                                                                : library;
    series.points.push_back(point_of(cell));
  }
  plot.series = {std::move(front), std::move(papers), std::move(unit), std::move(library)};
  return page::svg(plot);
}

std::vector<std::string> standing_plots(const std::string& name, const std::vector<Cell>& cells) {
  std::vector<std::string> plots;
  for (const TruthKind& truth : kTruthKinds) {
    for (const Currency& currency : kCurrencies) {
      if (std::ranges::none_of(cells, currency.counts)) continue;
      const std::string drawing = standing_plot(fmt::format("{}-{}-{}", name, truth.name, currency.name),
                                                fmt::format("{}: {}", name, truth.label), cells, currency, truth);
      plots.push_back(
          page::figure(drawing, fmt::format("Error against the {}, over {}.", truth.label, currency.label)));
    }
  }
  return plots;
}

}  // namespace feline
