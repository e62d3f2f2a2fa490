// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/standing.h"

#include <algorithm>

namespace feline {
namespace {

double mean_square(const Cell& cell, const TruthKind& truth) { return (cell.*truth.errors).errors.mean_square; }

void add_errors(CellErrors& sum, const CellErrors& errors, double share) {
  sum.errors.mean_square += share * errors.errors.mean_square;
  sum.errors.worst = std::max(sum.errors.worst, errors.errors.worst);
}

}  // namespace

const std::array<Currency, 3> kCurrencies{
    {{"nanoseconds", "nanoseconds a pixel, one thread of this machine",
      [](const Cell& cell) { return cell.nanoseconds; },
      [](const Contestant& contestant) { return contestant.kind != Contestant::Kind::kUnit; }},
     {"cycles", "cycles a pixel, eight texels each", [](const Cell& cell) { return cell.cost.stamp_cycles; },
      [](const Contestant& contestant) { return contestant.kind != Contestant::Kind::kLibrary; }},
     {"texels", "texels a pixel", [](const Cell& cell) { return cell.cost.texels; },
      [](const Contestant& contestant) { return contestant.kind != Contestant::Kind::kLibrary; }}}};

const std::array<TruthKind, 2> kTruthKinds{
    {{"gaussian", "Gaussian truth", &Cell::gaussian}, {"box", "box truth", &Cell::box}}};

std::vector<const Cell*> pareto_front(const std::vector<Cell>& cells, const Currency& currency,
                                      const TruthKind& truth) {
  std::vector<const Cell*> sorted;
  for (const Cell& cell : cells) {
    if (currency.counts(*find_contestant(cell.contestant))) sorted.push_back(&cell);
  }
  std::ranges::stable_sort(sorted, [&](const Cell* a, const Cell* b) {
    const double cost_a = currency.of(*a);
    const double cost_b = currency.of(*b);
    return cost_a != cost_b ? cost_a < cost_b : mean_square(*a, truth) < mean_square(*b, truth);
  });
  std::vector<const Cell*> front;
  for (const Cell* const cell : sorted) {
    if (front.empty() || mean_square(*cell, truth) < mean_square(*front.back(), truth)) front.push_back(cell);
  }
  return front;
}

bool on_front(const std::vector<const Cell*>& front, const Cell& cell) {
  return std::ranges::find(front, &cell) != front.end();
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
      all.visible += share * cell->visible;
      all.nanoseconds += share * cell->nanoseconds;
      all.cost.probes += share * cell->cost.probes;
      all.cost.texels += share * cell->cost.texels;
      all.cost.cycles += share * cell->cost.cycles;
      all.cost.stamp_cycles += share * cell->cost.stamp_cycles;
      if (cell->rtl_cycles) all.rtl_cycles = all.rtl_cycles.value_or(0) + share * *cell->rtl_cycles;
    }
    if (everywhere) pooled.push_back(std::move(all));
  }
  return pooled;
}

double psnr_ahead(const CellErrors& a, const CellErrors& b) {
  return a.errors.mean_square == b.errors.mean_square ? 0 : a.errors.psnr() - b.errors.psnr();
}

const Cell* find_cell(const ExhibitResult& result, std::string_view contestant) {
  const auto found = std::ranges::find(result.cells, contestant, &Cell::contestant);
  return found == result.cells.end() ? nullptr : &*found;
}

}  // namespace feline
