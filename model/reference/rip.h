// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/lookup.h"
#include "model/reference/probe.h"

namespace feline::reference {

// RIP mapping: images prefiltered in each direction on its own. Good where the footprint lies along a texture axis.

// How often the texture is halved in s and in t at a lookup: log2 of the larger part of the two gradients in each
// direction, in texels, 0 where that is below a texel.
struct RipLevel {
  double s;
  double t;
};
RipLevel rip_level(const RipMap& map, const Lookup& lookup);

// As SGI's runway demo ("Anisotropic", 1998): for each polygon, from its middle, one image of the texture with the
// fitting ratio, in whole halvings; that image is then mip-mapped and read trilinearly.
Colour rip_polygon_filter(const RipMap& map, const Lookup& polygon_middle, const Lookup& lookup, Cost& cost);

// A ratio for each pixel, four images blended.
Colour rip_pixel_filter(const RipMap& map, const Lookup& lookup, Cost& cost);

}  // namespace feline::reference
