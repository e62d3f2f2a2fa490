// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/measure/survey.h"
#include "testbench/report/claims.h"

namespace feline {

// The survey as one page that needs no network. Throws InputError when gnuplot is missing.
std::string report_page(const Survey& survey, const std::vector<Claim>& claims);

}  // namespace feline
