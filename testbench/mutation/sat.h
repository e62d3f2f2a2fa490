// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "testbench/mutation/aiger.h"

// What abc says of a circuit with a mutant in 20 seconds. Each throws std::runtime_error when it fails.
namespace feline::mutation {

// Whether all logic is proved the same, registers cut open.
bool same_logic(const Aiger& right, const Aiger& wrong);

// Whether it is proved that nobody sees a difference (observed_difference).
bool unobserved(const Aiger& right, const Aiger& wrong);

// Whether any legal beat comes out of a pipeline otherwise (steady_flow); nothing when it is not decided.
std::optional<bool> flows_otherwise(const Aiger& right, const Aiger& wrong);

}  // namespace feline::mutation
