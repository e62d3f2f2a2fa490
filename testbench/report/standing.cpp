// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/standing.h"

#include <fmt/format.h>

#include <algorithm>

namespace feline {
namespace {

Contestant::Kind kind_of(const Cell& cell) { return find_contestant(cell.contestant)->kind; }

double mean_square(const Cell& cell, const TruthKind& truth) { return (cell.*truth.errors).errors.mean_square; }

void add_errors(CellErrors& sum, const CellErrors& errors, double share) {
  sum.errors.mean_square += share * errors.errors.mean_square;
  sum.butteraugli += share * errors.butteraugli;
  sum.errors.worst = std::max(sum.errors.worst, errors.errors.worst);
}

}  // namespace

const std::array<Currency, 4> kCurrencies{
    {{"nanoseconds", "ns", "nanoseconds a pixel, one thread of this machine",
      [](const Cell& cell) { return cell.nanoseconds; },
      [](const Cell& cell) { return kind_of(cell) != Contestant::Kind::kUnit; }},
     {"cycles", "cycles", "cycles a pixel, eight texels each", [](const Cell& cell) { return cell.cost.stamp_cycles; },
      [](const Cell& cell) { return kind_of(cell) != Contestant::Kind::kLibrary; }},
     {"texels", "texels", "texels a pixel", [](const Cell& cell) { return cell.cost.texels; },
      [](const Cell& cell) { return kind_of(cell) != Contestant::Kind::kLibrary; }},
     {"rtl_cycles", "RTL cycles", "RTL cycles a pixel, measured",
      [](const Cell& cell) { return cell.rtl_cycles.value_or(0); },
      [](const Cell& cell) { return cell.rtl_cycles.has_value(); }}}};

const std::array<TruthKind, 2> kTruthKinds{
    {{"gaussian", "Gaussian truth", &Cell::gaussian}, {"box", "box truth", &Cell::box}}};

std::vector<const Cell*> pareto_front(const std::vector<Cell>& cells, const Currency& currency,
                                      const TruthKind& truth) {
  std::vector<const Cell*> sorted;
  for (const Cell& cell : cells) {
    if (currency.counts(cell)) sorted.push_back(&cell);
  }
  std::ranges::stable_sort(sorted, [&](const Cell* a, const Cell* b) {
    const double cost_a = currency.of(*a);
    const double cost_b = currency.of(*b);
    return cost_a != cost_b ? cost_a < cost_b : mean_square(*a, truth) < mean_square(*b, truth);
  });
  std::vector<const Cell*> front;
  for (const Cell* const cell : sorted) {
    const bool nearer = front.empty() || mean_square(*cell, truth) < mean_square(*front.back(), truth);
    const bool equal = !nearer && currency.of(*cell) == currency.of(*front.back()) &&
                       mean_square(*cell, truth) == mean_square(*front.back(), truth);
    if (nearer || equal) front.push_back(cell);
  }
  return front;
}

bool on_front(const std::vector<const Cell*>& front, const Cell& cell) {
  return std::ranges::find(front, &cell) != front.end();
}

std::vector<std::string> fronts_of(const std::vector<Cell>& cells, const Cell& cell) {
  std::vector<std::string> names;
  for (const TruthKind& truth : kTruthKinds) {
    for (const Currency& currency : kCurrencies) {
      if (on_front(pareto_front(cells, currency, truth), cell)) {
        names.push_back(fmt::format("{}:{}", truth.name, currency.name));
      }
    }
  }
  return names;
}

std::vector<Cell> pool_exhibits(const Survey& survey) {
  std::vector<Cell> pooled;
  if (survey.results.empty()) return pooled;
  for (const Cell& first : survey.results.front().cells) {
    Cell all;
    all.exhibit = "all";
    all.contestant = first.contestant;
    const double share = 1 / static_cast<double>(survey.results.size());
    bool everywhere = true;
    for (const ExhibitResult& result : survey.results) {
      const Cell* const cell = find_cell(result, first.contestant);
      everywhere = everywhere && cell != nullptr;
      if (cell == nullptr) break;
      add_errors(all.gaussian, cell->gaussian, share);
      add_errors(all.box, cell->box, share);
      all.nanoseconds += share * cell->nanoseconds;
      all.cost += share * cell->cost;
      if (cell->rtl_cycles) all.rtl_cycles = all.rtl_cycles.value_or(0) + share * *cell->rtl_cycles;
    }
    if (everywhere) pooled.push_back(std::move(all));
  }
  return pooled;
}

double psnr_ahead(const CellErrors& a, const CellErrors& b) {
  return a.errors.mean_square == b.errors.mean_square ? 0 : a.errors.psnr() - b.errors.psnr();
}

std::string worst_pixel(const ExhibitPlan& plan, const CellErrors& errors) {
  const std::string at = fmt::format("({}, {})", errors.errors.worst_column, errors.errors.worst_row);
  return plan.frame_count > 1 ? fmt::format("{} of frame {}", at, errors.worst_frame) : at;
}

const Cell* find_cell(const ExhibitResult& result, std::string_view contestant) {
  const auto found = std::ranges::find(result.cells, contestant, &Cell::contestant);
  return found == result.cells.end() ? nullptr : &*found;
}

}  // namespace feline
