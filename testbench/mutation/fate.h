// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "testbench/mutation/stage_mutants.h"
#include "testbench/mutation/workshop.h"

namespace feline::mutation {

// What became of a mutant.
struct Fate {
  Mutant mutant{};
  std::string name{};        // what it is, in words
  std::string tier{};        // that killed it; empty for a survivor
  std::string stage{};       // that the mismatch named, or a leaf; "pace" when no beat was wrong
  std::uint64_t lookup = 0;  // of the mismatch; of a leaf, the number of the input
  std::uint64_t cycles = 0;
  double milliseconds = 0;
  // Of a survivor: its logic, with all registers and memories cut open, is that of the stage, or that of its leaf for
  // all that can come in; or nobody who keeps to the streams' rules sees a difference (observed_difference), the
  // registers of either beginning with 0.
  enum class Logic : std::uint8_t { kUnknown, kSame, kUnobserved } logic = Logic::kUnknown;
  std::string differs{};  // a legal beat that comes out otherwise, says SAT, but none that was tried did
  bool proved() const { return logic != Logic::kUnknown; }
  // Neither killed nor proved the same.
  bool is_open() const { return tier.empty() && !proved(); }
};

// A line of each mutant's code.
std::string codes_of(std::span<Fate* const> fates);

// Tries those that no tier has killed and that are not proved the same on these tiers (trial.h), after building the
// stage with its mutants. What is in the cache is not tried again. Throws InputError or std::runtime_error when that is
// not possible.
void try_mutants(const StageMutants& stage, const std::vector<std::string>& tiers, const Workshop& workshop,
                 std::vector<Fate>& fates);

// Tries those that no tier has killed and that are not proved the same on the leaves of `feline prove` that the stage
// is made of: what differs anywhere in a domain, its enumeration kills, tier kExhaustive; what differs nowhere in a
// complete one, or one that is for its instance, is proved the same; std::runtime_error if SAT knows better. Quick: at
// 2^24 inputs of each leaf; else at all of a complete one, and at 2^32 of any other.
inline constexpr const char* kExhaustive = "exhaustive";
void try_leaves(const StageMutants& stage, bool quick, const Workshop& workshop, std::vector<Fate>& fates);

// Proves by SAT (abc pdr) of the registers of a pipeline or the unit, each by itself, that nobody sees a difference:
// what leaves one while it is not valid, no other one takes.
void prove_registers(const StageMutants& stage, const Workshop& workshop, std::vector<Fate>& fates);

// Proves of the unit's mutants at a stage's port that nobody sees a difference in that stage, for all that may come in.
void prove_ports(const StageMutants& unit, const Workshop& workshop, std::vector<Fate>& fates);

// Proves by SAT what it can of those that no tier has killed: that all their logic is the stage's (abc &cec); or that
// nobody sees a difference: in a pipeline's arithmetic, of what comes out for a legal beat (CaDiCaL),
// elsewhere at any time (abc pdr), memories cut (cut_memories). Of ROMs' bits the latter: nobody sees what a word is.
void compare_logic(const StageMutants& stage, Fate::Logic wanted, const Workshop& workshop, std::vector<Fate>& fates);

}  // namespace feline::mutation
