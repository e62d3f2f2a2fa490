// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>

namespace feline {
namespace {

// A guess at size that rises with every width and feature, so that units are asked for from the least up.
int size_guess(const Config& config) {
  int sum = FormatSet(config).position.width() - config.guard_bits;
  for (const ConfigField& each : kConfigFields) sum += config.*each.field;
  for (const FeatureField& each : kFeatureFields) sum += config.features.*each.field ? 4 : 0;
  return sum;
}

bool strictly_needs_less(const Config& unit, const Config& than) {
  return needs_no_more(unit, than) && !needs_no_more(than, unit);
}

std::optional<double> known_gates(std::span<const Measurement> measurements, const Costs& counted,
                                  const Config& hardware) {
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (counted[i] && measurements[i].hardware == hardware) return counted[i];
  }
  return std::nullopt;
}

// Some known unit that needs no more has as many: so has this one, at least.
double least_gates(std::span<const Measurement> measurements, const Costs& counted, const Config& hardware) {
  double least = 0;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (counted[i] && needs_no_more(measurements[i].hardware, hardware)) least = std::max(least, *counted[i]);
  }
  return least;
}

}  // namespace

std::string budget_name(const Budget& budget) {
  return budget.kind == Budget::Kind::kDecibels ? fmt::format("{} dB", budget.limit)
                                                : fmt::format("worst pixel {}", budget.limit);
}

const Errors& errors_of(const Measurement& measurement, TruthChoice truth) {
  return truth == TruthChoice::kGaussian ? measurement.gaussian : measurement.box;
}

double loss(const Errors& errors, const Errors& full) {
  return errors.mean_square == full.mean_square ? 0 : full.psnr() - errors.psnr();
}

bool holds(const Errors& errors, const Errors& full, const Budget& budget) {
  return budget.kind == Budget::Kind::kDecibels ? loss(errors, full) <= budget.limit
                                                : 255 * errors.worst <= budget.limit;
}

Costs measured_costs(std::span<const Measurement> measurements, CostKind kind) {
  Costs costs;
  for (const Measurement& each : measurements) {
    costs.emplace_back(kind == CostKind::kCycles ? each.cycles : each.nanoseconds);
  }
  return costs;
}

std::vector<std::size_t> holding(std::span<const Measurement> measurements, const Errors& full, TruthChoice truth,
                                 const Budget& budget) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (holds(errors_of(measurements[i], truth), full, budget)) places.push_back(i);
  }
  return places;
}

void count_gates(std::span<const Measurement> measurements, std::span<const std::size_t> holding,
                 const GateCount& gates, Costs& counted, Progress& progress) {
  std::vector<std::size_t> least(holding.begin(), holding.end());
  std::erase_if(least, [&](std::size_t i) {
    return std::ranges::any_of(holding, [&](std::size_t other) {
      return strictly_needs_less(measurements[other].hardware, measurements[i].hardware);
    });
  });
  std::ranges::stable_sort(least, {}, [&](std::size_t i) { return size_guess(measurements[i].hardware); });
  double best = std::numeric_limits<double>::infinity();
  Progress part(progress, kGatesWork, least.size());
  for (const std::size_t i : least) {
    part.advance(1);
    const Config& hardware = measurements[i].hardware;
    if (!counted[i]) counted[i] = known_gates(measurements, counted, hardware);
    if (!counted[i] && least_gates(measurements, counted, hardware) >= best) continue;
    if (!counted[i]) counted[i] = gates(hardware);
    best = std::min(best, *counted[i]);
  }
}

std::optional<std::size_t> choose(std::span<const Measurement> measurements, const Costs& costs,
                                  std::span<const std::size_t> holding, TruthChoice truth) {
  std::optional<std::size_t> chosen;
  for (const std::size_t i : holding) {
    if (!costs[i]) continue;
    // Of equal costs the plainest mode, then the narrowest unit, then the least error.
    const auto rank = [&](std::size_t place) {
      const Candidate& candidate = measurements[place].candidate;
      const Widths& widths = candidate.widths;
      return std::tuple(*costs[place], candidate.mode, candidate.kernel,
                        widths.mantissa_bits + widths.table_side + widths.subtexel_bits + widths.level_fraction_bits +
                            widths.weight_bits,
                        errors_of(measurements[place], truth).mean_square);
    };
    if (!chosen || rank(i) < rank(*chosen)) chosen = i;
  }
  return chosen;
}

std::vector<std::size_t> pareto_front(std::span<const Measurement> measurements, const Costs& costs,
                                      TruthChoice truth) {
  std::vector<std::size_t> sorted;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (costs[i]) sorted.push_back(i);
  }
  const auto error = [&](std::size_t i) { return errors_of(measurements[i], truth).mean_square; };
  std::ranges::stable_sort(sorted, [&](std::size_t a, std::size_t b) {
    return *costs[a] != *costs[b] ? *costs[a] < *costs[b] : error(a) < error(b);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : sorted) {
    if (front.empty() || error(i) < error(front.back())) front.push_back(i);
  }
  return front;
}

std::optional<std::size_t> cheaper_one(std::span<const Measurement> measurements, const Costs& costs,
                                       const Errors& full, TruthChoice truth, const Budget& budget,
                                       std::size_t chosen) {
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    if (!holds(errors_of(measurements[i], truth), full, budget)) continue;
    const double cost = costs[i] ? *costs[i] : least_gates(measurements, costs, measurements[i].hardware);
    if (cost < *costs[chosen]) return i;
  }
  return std::nullopt;
}

SceneSearch search_scene(const ExhibitPlan& plan, const SearchOptions& options, const Cache& cache,
                         Progress& progress) {
  BudgetScene scene(plan, options.survey, cache);
  SceneSearch search{plan, scene.measure_all(progress), 0, {}, 0, {}, {}};
  const std::vector<Measurement>& all = search.measurements;
  const auto found = std::ranges::find(all, full_candidate(options.kernel), &Measurement::candidate);
  search.full = static_cast<std::size_t>(found - all.begin());
  const Errors& full = errors_of(all[search.full], options.truth);
  const auto holders = [&](const Budget& budget) { return holding(all, full, options.truth, budget); };
  if (options.cost == CostKind::kGates) {
    search.costs.resize(all.size());
    Progress part(progress, kGatesWork, options.budgets.size() * kGatesWork);
    search.full_cost = options.gates(kDefaultConfig);
    search.costs[search.full] = options.gates(all[search.full].hardware);
    for (const Budget& budget : options.budgets) {
      count_gates(all, holders(budget), options.gates, search.costs, part);
    }
  } else {
    search.costs = measured_costs(all, options.cost);
    search.full_cost = *search.costs[search.full];
  }
  search.front = pareto_front(all, search.costs, options.truth);
  for (const Budget& budget : options.budgets) {
    const std::vector<std::size_t> places = holders(budget);
    BudgetChoice choice{budget, choose(all, search.costs, places, options.truth), {}, false, places.size()};
    if (choice.chosen) {
      choice.verified = scene.measure(all[*choice.chosen].candidate);
      choice.holds = holds(errors_of(*choice.verified, options.truth), full, budget) &&
                     !cheaper_one(all, search.costs, full, options.truth, budget, *choice.chosen);
    }
    search.choices.push_back(choice);
  }
  return search;
}

}  // namespace feline
