// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/stability/study.h"

namespace feline::stability {

// Figures of the study, with captions; only those that it has the numbers for. Throws InputError without gnuplot.
std::vector<std::string> plots(const Study& study);

}  // namespace feline::stability
