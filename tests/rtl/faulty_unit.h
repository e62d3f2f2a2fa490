// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "testbench/cosim/rtl_unit.h"

namespace feline {

// The fault that units of this thread have; 0 is none. Set it before a unit is made.
void set_fault(int number);
// Of each stage in how many cycles units of this thread gave it what the rules of its mutants call illegal, since the
// last call; none of a stage that got none.
using BrokenRules = std::map<std::string, std::uint64_t>;
BrokenRules take_broken_rules();
std::unique_ptr<RtlUnit> make_faulty_unit(std::uint64_t seed);
// The same with waveforms.
std::unique_ptr<RtlUnit> make_faulty_trace_unit(std::uint64_t seed);

}  // namespace feline
