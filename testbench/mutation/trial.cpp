// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "tables/stages.h"
#include "testbench/cosim/random_batches.h"
#include "testbench/error.h"

namespace feline::mutation {
namespace {

constexpr std::uint64_t kBatchLookups = 256;

struct Outcome {
  std::optional<Mismatch> mismatch;
  std::uint64_t cycles = 0;
  std::uint64_t pace = 0;
};

Outcome run_tier(const Tier& tier, const std::optional<CloseBatches>& close) {
  RandomBatches random(tier.timing.seed, kBatchLookups);
  if (tier.vary) random.vary_conditions();
  const std::uint64_t batches = tier.close ? close->size() : (tier.lookups + kBatchLookups - 1) / kBatchLookups;
  Cosimulation simulation(make_mutated_unit, tier.timing);
  for (std::uint64_t number = 0; number < batches; ++number) {
    if (!simulation.run(tier.close ? (*close)[number] : random.make(number, tier.lookups))) break;
  }
  return {simulation.mismatch(), simulation.cycles(), simulation.pace()};
}

}  // namespace

std::vector<Tier> tiers(std::span<const std::string> names) {
  static const std::vector<Tier> all{{"smoke", 2000, {5, 0.1, 1}, false, false},
                                     {"close", 1500, {5, 0.3, 5}, false, false, true},
                                     {"pace", 20000, {3, 0.2, 2}, false, true},
                                     {"suite", 100000, {1, 0, 3}, true, false},
                                     {"long", 400000, {7, 0.1, 4}, true, false}};
  std::vector<Tier> chosen;
  for (const std::string& name : names) {
    const auto tier = std::ranges::find(all, name, &Tier::name);
    if (tier == all.end()) bad_input("command line", "tier", name, "smoke, close, pace, suite, long");
    chosen.push_back(*tier);
  }
  return chosen;
}

Trial::Trial(std::vector<Tier> tiers) : tiers_(std::move(tiers)) {
  set_mutant(0);
  for (const Tier& tier : tiers_) {
    if (tier.close) close_.emplace(tier.timing.seed, tier.lookups);
    const Outcome outcome = run_tier(tier, close_);
    if (outcome.mismatch) {
      throw WitnessMismatch(fmt::format("the unit without a mutant fails in {}; feline cosim tells where", tier.name));
    }
    right_.push_back(outcome.pace);
  }
}

std::optional<Death> Trial::run(std::uint64_t code) const {
  const auto start = std::chrono::steady_clock::now();
  set_mutant(code);
  for (std::size_t i = 0; i < tiers_.size(); ++i) {
    const Outcome outcome = run_tier(tiers_[i], close_);
    const bool late = tiers_[i].exact && outcome.pace != right_[i];
    if (!outcome.mismatch && !late) continue;
    Death death;
    death.tier = tiers_[i].name;
    death.stage = outcome.mismatch ? kStageNames[static_cast<std::size_t>(outcome.mismatch->stage)] : "pace";
    death.lookup = outcome.mismatch ? outcome.mismatch->lookup : 0;
    death.cycles = outcome.cycles;
    death.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return death;
  }
  return std::nullopt;
}

}  // namespace feline::mutation
