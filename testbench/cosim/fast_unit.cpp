// SPDX-License-Identifier: Apache-2.0
#include <Vfeline_fast.h>

#include "testbench/cosim/verilated_unit.h"

namespace feline {

std::unique_ptr<RtlUnit> make_fast_unit(std::uint64_t seed) {
  return std::make_unique<VerilatedUnit<Vfeline_fast>>(seed);
}

}  // namespace feline
