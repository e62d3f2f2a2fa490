// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "testbench/area/synthesis.h"
#include "testbench/budget/search.h"

namespace feline {

// The text of the unit of any legal configuration: its package and ROMs, made now, and the modules in `rtl`; but
// for comments that of generated files. Throws InputError when the modules are missing.
std::string unit_source(const Config& config, const std::filesystem::path& rtl);

// Gates of units by synthesis, minutes each; what its cache holds is known at once. `synthesis` stays valid as long as
// the function.
GateCount synthesized_gates(const Synthesis& synthesis, const std::filesystem::path& rtl);

}  // namespace feline
