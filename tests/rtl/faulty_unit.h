// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/cosim/rtl_unit.h"

namespace feline {

// The fault that units of this thread have; 0 is none. Set it before a unit is made.
void set_fault(int number);
std::unique_ptr<RtlUnit> make_faulty_unit(std::uint64_t seed);
// The same with waveforms.
std::unique_ptr<RtlUnit> make_faulty_trace_unit(std::uint64_t seed);

}  // namespace feline
