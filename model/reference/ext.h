// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/line.h"

namespace feline::reference {

// The example implementation of EXT_texture_filter_anisotropic (2000): N = min(ceil(Pmax/Pmin), max_anisotropy) probes
// of equal weight at i/(N + 1) - 1/2 along the longer gradient, y on a tie, each at log2(Pmax/N).
ProbeLine plan_ext(const Gradients<double>& gradients, int max_anisotropy);

Colour ext_filter(const MipMap& map, int max_anisotropy, const Lookup& lookup, Cost& cost);

}  // namespace feline::reference
