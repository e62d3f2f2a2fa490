// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/cosim/rtl_unit.h"

namespace feline {

// The fault that units of this thread have; 0 is none. Set it before a unit is made.
void set_fault(int number);
// In how many cycles a unit of this thread had a beat that the rules of mutants call illegal, since the last call.
std::uint64_t take_broken_rules();
std::unique_ptr<RtlUnit> make_faulty_unit(std::uint64_t seed);
// The same with waveforms.
std::unique_ptr<RtlUnit> make_faulty_trace_unit(std::uint64_t seed);

}  // namespace feline
