// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/stability/study.h"

namespace feline::stability {

// The study as one HTML file. Throws InputError without gnuplot.
std::string to_html(const Study& study);

}  // namespace feline::stability
