// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace feline {

// What tests/rtl/fault_list.cmake lists.
struct Fault {
  int number;
  const char* stage;
  const char* what;
};

inline constexpr Fault kFaults[] = {
#include "fault_table.inc"
};

constexpr const Fault* find_fault(std::string_view what) {
  for (const Fault& fault : kFaults) {
    if (what == fault.what) return &fault;
  }
  return nullptr;
}

}  // namespace feline
