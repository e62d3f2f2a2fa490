// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/measure/survey.h"

namespace feline {

// What a pixel costs.
struct Currency {
  std::string_view name;   // of plots and fields
  std::string_view title;  // of columns
  std::string_view label;  // of an axis
  double (*of)(const Cell& cell);
  // The bit-accurate model's time says nothing of hardware; a library tells neither texels nor cycles; RTL is the
  // unit's only.
  bool (*counts)(const Cell& cell);
};
extern const std::array<Currency, 4> kCurrencies;  // nanoseconds, cycles, texels, RTL cycles

// What a pixel ought to be: the Gaussian, then the box.
struct TruthKind {
  std::string_view name;
  std::string_view label;
  CellErrors Cell::*errors;
};
extern const std::array<TruthKind, 2> kTruthKinds;

// The cells that no other one beats in both cost and error, cheapest first.
std::vector<const Cell*> pareto_front(const std::vector<Cell>& cells, const Currency& currency, const TruthKind& truth);
bool on_front(const std::vector<const Cell*>& front, const Cell& cell);
// The fronts that one of the cells is on, each as TRUTH:CURRENCY.
std::vector<std::string> fronts_of(const std::vector<Cell>& cells, const Cell& cell);

// Each contestant over all exhibits that it was measured on, if on every one: mean costs, pooled mean squares; the
// worst of the worst errors. Named "all".
std::vector<Cell> pool_exhibits(const Survey& survey);

// By how many decibels `a` is nearer to the truth than `b`; 0 where neither has any error.
double psnr_ahead(const CellErrors& a, const CellErrors& b);

// "column, row" of the worst error, and the frame of a sequence.
std::string worst_pixel(const ExhibitPlan& plan, const CellErrors& errors);

// Null where it was not measured.
const Cell* find_cell(const ExhibitResult& result, std::string_view contestant);

}  // namespace feline
