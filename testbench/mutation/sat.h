// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/mutation/aiger.h"

// What solvers say of a circuit with a mutant. Each throws InputError when a tool is not there, std::runtime_error when
// it fails.
namespace feline::mutation {

// Whether all logic is proved the same by abc in 20 seconds, registers cut open.
bool same_logic(const Aiger& right, const Aiger& wrong);

// Whether it is proved by abc in 20 seconds that nobody sees a difference (observed_difference).
bool unobserved(const Aiger& right, const Aiger& wrong);

// Inputs for which the only output of a circuit without state is 1, or that there are none, says CaDiCaL.
struct Satisfied {
  enum class Answer : std::uint8_t { kNever, kSometimes, kUndecided } answer = Answer::kUndecided;
  std::vector<bool> inputs{};
};
Satisfied satisfy(const Aiger& aiger, int seconds);

// Whether any legal beat comes out of a pipeline otherwise (steady_flow), and if so which; each question has 30
// seconds. Undecided also when beats do not move by themselves. Throws std::runtime_error when no beat is legal.
Satisfied flows_otherwise(const Aiger& right, const Aiger& wrong);

std::string solver_version();

}  // namespace feline::mutation
