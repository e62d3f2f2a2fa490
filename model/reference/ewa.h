// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/lookup.h"
#include "model/reference/probe.h"

namespace feline::reference {

// Elliptical Weighted Average (Greene and Heckbert 1986; Heckbert 1989), as WRL 99/1, 2.1 describes it: every texel
// inside the ellipse, weighted by exp(-2 d^2).
struct EwaParameters {
  bool mip_mapped = true;        // reads the level where the minor radius is 1.5 to 3 texels; false: level 0
  double max_eccentricity = 16;  // ellipses longer than this are widened, so that the time is bounded; 0: never
  bool reconstructs = true;      // on level 0 the ellipse is united with the reconstruction filter; false: as it is
};

// d^2 = a u^2 + b u v + c v^2 of a point (u, v) off the middle, in texels of a level; d = 1 at the ellipse.
struct EwaEllipse {
  int level = 0;
  double a = 0;
  double b = 0;
  double c = 0;
  double half_width = 0;  // of the box around it
  double half_height = 0;
};

// On level 0 Heckbert's union with the reconstruction filter adds 1 to both squared radii (3.1): an ellipse then holds
// a texel however small it is. Coarser levels are filtered already. No radius exceeds 48 texels of a coarser level, of
// which the last one would else be read again and again, and no ellipse of level 0 has more than 2^18 texels.
EwaEllipse plan_ewa(const MipMap& map, const EwaParameters& parameters, const Gradients<double>& normalized);

// Cost: Optimistic EWA takes eight texels a cycle, Realistic EWA one stamp a cycle, 4 x 2 texels for wide ellipses and
// 2 x 4 for high ones, each at a multiple of its size (WRL 99/1, section 4).
Colour ewa_filter(const MipMap& map, const EwaParameters& parameters, const Lookup& lookup, Cost& cost);

}  // namespace feline::reference
