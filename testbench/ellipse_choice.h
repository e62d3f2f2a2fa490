// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/roms.h"

namespace feline {

// Errors of an ellipse table over all cells: level of detail in octaves, relative major radius, and the end of the
// probe line in minor radii. They decide how an entry stands for its cell; the tables' bytes do not depend on them.
struct EllipseErrors {
  double worst_level = 0, mean_level = 0;
  double worst_major = 0, mean_major = 0;
  double worst_line = 0, mean_line = 0;
};

// On a lattice of (lattice + 1)^2 points a cell, its edges included, with at most config.max_probes probes.
EllipseErrors ellipse_errors(const Config& config, const Rom& ellipse, int lattice);

}  // namespace feline
