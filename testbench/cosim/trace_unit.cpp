// SPDX-License-Identifier: Apache-2.0
#include <Vfeline_trace.h>
#include <verilated_fst_c.h>

#include "testbench/cosim/verilated_unit.h"

namespace feline {

std::unique_ptr<RtlUnit> make_trace_unit(std::uint64_t seed) {
  return std::make_unique<VerilatedUnit<Vfeline_trace, VerilatedFstC>>(seed);
}

}  // namespace feline
