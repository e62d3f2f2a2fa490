// SPDX-License-Identifier: Apache-2.0
#include <Vfeline_mutated.h>

#include "testbench/cosim/verilated_unit.h"
#include "testbench/mutation/trial.h"

namespace {
thread_local std::uint64_t current_mutant = 0;
}

// Called from the RTL (DPI-C).
extern "C" std::uint64_t feline_mutant() { return current_mutant; }

namespace feline::mutation {

void set_mutant(std::uint64_t code) { current_mutant = code; }

std::unique_ptr<RtlUnit> make_mutated_unit(std::uint64_t seed) {
  return std::make_unique<VerilatedUnit<Vfeline_mutated>>(seed);
}

}  // namespace feline::mutation
