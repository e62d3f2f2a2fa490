// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testbench/budget/measurement.h"

namespace feline {

enum class TruthChoice : std::uint8_t { kGaussian, kBox };
inline constexpr std::array<std::string_view, 2> kTruthChoiceNames{"gaussian", "box"};

// What a pixel costs, or the unit.
enum class CostKind : std::uint8_t { kCycles, kGates, kNanoseconds };
inline constexpr std::array<std::string_view, 3> kCostNames{"cycles", "gates", "ns"};

struct Budget {
  enum class Kind : std::uint8_t {
    kDecibels,  // of PSNR less than the full unit's
    kWorst,     // error of the worst pixel, codes of 255
  };
  Kind kind = Kind::kDecibels;
  double limit = 0;
};
std::string budget_name(const Budget& budget);  // "0.5 dB", "worst pixel 12"

const Errors& errors_of(const Measurement& measurement, TruthChoice truth);
// PSNR lost against the full unit, dB; negative when it is gained.
double loss(const Errors& errors, const Errors& full);
bool holds(const Errors& errors, const Errors& full, const Budget& budget);

// NAND2 equivalents of a unit. Slow: it is asked for as few units as possible, for none twice.
using GateCount = std::function<double(const Config& hardware)>;

// Measurements and what each costs, by place; nothing where it was never needed.
using Costs = std::vector<std::optional<double>>;

// Of cycles and ns every cost is known.
Costs measured_costs(std::span<const Measurement> measurements, CostKind kind);

// Asks for gates until the least of all measurements that hold the budget is known. `counted` keeps what is known.
// Only units that need no more than no other one are asked for (needs_no_more), and of those none that has to be at
// least as large as the least so far, because it needs no less than one that is.
void count_gates(std::span<const Measurement> measurements, std::span<const std::size_t> holding,
                 const GateCount& gates, Costs& counted, Progress& progress);

// Places of those that hold.
std::vector<std::size_t> holding(std::span<const Measurement> measurements, const Errors& full, TruthChoice truth,
                                 const Budget& budget);

// The least cost of those that hold the budget; of equal costs the plainest mode, then the narrowest unit, then the
// least error. Nothing when none holds, or no cost is known.
std::optional<std::size_t> choose(std::span<const Measurement> measurements, const Costs& costs,
                                  std::span<const std::size_t> holding, TruthChoice truth);

// No other one is cheaper and as near to the truth, or nearer and as cheap; cheapest first.
std::vector<std::size_t> pareto_front(std::span<const Measurement> measurements, const Costs& costs, TruthChoice truth);

// A measurement that holds the budget at less cost than the chosen one, or, where its cost is not known, could: looked
// for one by one in all of them. Nothing is what should be found.
std::optional<std::size_t> cheaper_one(std::span<const Measurement> measurements, const Costs& costs,
                                       const Errors& full, TruthChoice truth, const Budget& budget, std::size_t chosen);

struct BudgetChoice {
  Budget budget;
  std::optional<std::size_t> chosen;    // place in the measurements
  std::optional<Measurement> verified;  // measured anew
  bool holds = false;                   // it does, measured anew, and nothing cheaper does
  std::size_t holding = 0;              // candidates that hold the budget
};

struct SearchOptions {
  BudgetSurveyOptions survey;
  std::vector<Budget> budgets;
  TruthChoice truth = TruthChoice::kGaussian;
  CostKind cost = CostKind::kCycles;
  Kernel kernel = Kernel::kBilinear;  // of the full unit
  GateCount gates;                    // for CostKind::kGates
};

struct SceneSearch {
  ExhibitPlan plan;
  std::vector<Measurement> measurements;
  std::size_t full = 0;  // place of the full unit
  Costs costs;
  double full_cost = 0;            // of the full unit; its gates are those of the default configuration
  std::vector<std::size_t> front;  // of those whose cost is known
  std::vector<BudgetChoice> choices;
};

// The total of a search's progress: measurements, and syntheses, which take longer.
inline constexpr std::uint64_t kMeasuringWork = 5000;
inline constexpr std::uint64_t kGatesWork = 10000;
constexpr std::uint64_t search_work(CostKind cost) {
  return kMeasuringWork + (cost == CostKind::kGates ? kGatesWork : 0);
}
SceneSearch search_scene(const ExhibitPlan& plan, const SearchOptions& options, const Cache& cache, Progress& progress);

}  // namespace feline
