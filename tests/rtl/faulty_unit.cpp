// SPDX-License-Identifier: Apache-2.0
#include "tests/rtl/faulty_unit.h"

#include <Vfeline_faulty.h>
#include <verilated_fst_c.h>

#include <utility>

#include "testbench/cosim/verilated_unit.h"

namespace {
thread_local int current_fault = 0;
thread_local feline::BrokenRules rules_broken;
}  // namespace

// Called from the RTL (DPI-C).
extern "C" int feline_fault() { return current_fault; }
extern "C" void feline_rule_broken(const char* stage) { ++rules_broken[stage]; }

namespace feline {

void set_fault(int number) { current_fault = number; }

BrokenRules take_broken_rules() { return std::exchange(rules_broken, {}); }

std::unique_ptr<RtlUnit> make_faulty_unit(std::uint64_t seed) {
  return std::make_unique<VerilatedUnit<Vfeline_faulty>>(seed);
}

std::unique_ptr<RtlUnit> make_faulty_trace_unit(std::uint64_t seed) {
  return std::make_unique<VerilatedUnit<Vfeline_faulty, VerilatedFstC>>(seed);
}

}  // namespace feline
