// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/measure/contestant.h"

namespace feline {

// The bit-accurate unit in each of its modes, and Feline with each set of parameters and each kernel.
std::vector<Contestant> unit_contestants();

}  // namespace feline
