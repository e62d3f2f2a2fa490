// SPDX-License-Identifier: Apache-2.0
// The units of feline_broken, the program with one fault in its RTL: FELINE_FAULT is the fault's number.
#include <cstdlib>
#include <string>

#include "tests/rtl/faulty_unit.h"

// Verilator 5.006 keeps a name in a thread_local pointer (catName) and loses it with the thread, in its own code.
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the name that the sanitizer looks for.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:Verilated::catName"; }
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

namespace feline {
namespace {

void set_fault_of_environment() {
  const char* const number = std::getenv("FELINE_FAULT");
  set_fault(number == nullptr ? 0 : std::stoi(number));
}

}  // namespace

std::unique_ptr<RtlUnit> make_fast_unit(std::uint64_t seed) {
  set_fault_of_environment();
  return make_faulty_unit(seed);
}

std::unique_ptr<RtlUnit> make_trace_unit(std::uint64_t seed) {
  set_fault_of_environment();
  return make_faulty_trace_unit(seed);
}

}  // namespace feline
