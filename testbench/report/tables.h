// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/page/html.h"
#include "testbench/report/standing.h"

namespace feline {

// Decibels with two digits; "equal" for a picture without error.
std::string decibels(double psnr);

// One row a contestant, sorted by error against the Gaussian truth; cells of a Pareto front are marked.
page::Table standing_table(const std::vector<Cell>& cells);

// The error against one truth over one currency, the Pareto front as a line with names.
std::string standing_plot(const std::string& name, const std::string& title, const std::vector<Cell>& cells,
                          const Currency& currency, const TruthKind& truth);
// Every truth, and every currency that one of them counts in.
std::vector<std::string> standing_plots(const std::string& name, const std::vector<Cell>& cells);

}  // namespace feline
