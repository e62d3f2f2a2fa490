// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/line.h"

namespace feline::reference {

// Texram (Schilling, Knittel, Strasser 1996), as WRL 99/1, 2.3 describes it.

// What the ratio of the longer side to the minor radius is rounded to: [1, 1.5) one probe, [1.5, 3) two, [3, 6) four.
int round_texram_probes(double ratio, int max_probes);

// Probes of equal weight on a line as long as the longer gradient, evenly spread, each as wide as the shortest of both
// gradients and both diagonals; not widened when their number is rounded down. At the limit of the probe count, of
// which 2.3 says nothing, they are as wide as the line asks, or every long footprint would alias.
ProbeLine plan_texram(const Gradients<double>& gradients, int max_probes);

Colour texram_filter(const MipMap& map, int max_probes, const Lookup& lookup, Cost& cost);

}  // namespace feline::reference
