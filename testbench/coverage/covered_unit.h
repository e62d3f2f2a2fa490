// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

#include "testbench/cosim/rtl_unit.h"

namespace feline {

// A unit whose every block of statements, branch and bit is counted.
struct CoveredUnit {
  std::unique_ptr<RtlUnit> unit;
  std::function<void()> forget;                                // all counts are 0 from now on
  std::function<void(const std::filesystem::path& to)> write;  // as Verilator has it, each instance on its own
};
CoveredUnit make_covered_unit(std::uint64_t seed);

}  // namespace feline
