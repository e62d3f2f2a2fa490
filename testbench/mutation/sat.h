// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "testbench/mutation/aiger.h"

// What solvers say of a circuit with a mutant. Each throws InputError when a tool is not there, std::runtime_error when
// it fails.
namespace feline::mutation {

// Whether all logic is proved the same by abc in 20 seconds, registers cut open.
bool same_logic(const Aiger& right, const Aiger& wrong);

// Whether it is proved by abc in 20 seconds that nobody sees a difference (observed_difference).
bool unobserved(const Aiger& right, const Aiger& wrong);

// Whether the only output of a circuit without state is 1 for any input, says CaDiCaL in 100 seconds; nothing when it
// does not decide.
std::optional<bool> satisfiable(const Aiger& aiger);

// Whether any legal beat comes out of a pipeline otherwise (steady_flow); nothing when it is not decided, or when beats
// do not move by themselves.
std::optional<bool> flows_otherwise(const Aiger& right, const Aiger& wrong);

std::string solver_version();

}  // namespace feline::mutation
