// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "testbench/cosim/close_batches.h"

namespace feline::mutation {

// Makes units that have the mutant of this thread.
void set_mutant(std::uint64_t code);
std::unique_ptr<RtlUnit> make_mutated_unit(std::uint64_t seed);

// What the mutants of a stage are tried on, in this order: each kills by a beat that differs from the model's, a broken
// stream rule or a hang; one tier also by a beat that leaves a stage in another cycle than without a mutant.
struct Tier {
  std::string name;
  std::uint64_t lookups = 0;
  Timing timing;
  bool vary = false;   // the conditions of every batch
  bool exact = false;  // in pace
  bool close = false;  // those of CloseBatches
};
// Throws InputError for a name that is none.
std::vector<Tier> tiers(std::span<const std::string> names);

// What killed a mutant.
struct Death {
  std::string tier;
  std::string stage;  // the one that the mismatch names; "pace" when no beat is wrong
  std::uint64_t lookup = 0;
  std::uint64_t cycles = 0;  // of this tier
  double milliseconds = 0;   // of this trial's tiers up to it
};

// Tries mutants on the tiers one after the other. Throws WitnessMismatch when the unit without a mutant fails.
class Trial {
 public:
  explicit Trial(std::vector<Tier> tiers);
  // Nothing for a survivor.
  std::optional<Death> run(std::uint64_t code) const;

 private:
  std::vector<Tier> tiers_;
  std::vector<std::uint64_t> right_;  // paces
  std::optional<CloseBatches> close_;
};

}  // namespace feline::mutation
