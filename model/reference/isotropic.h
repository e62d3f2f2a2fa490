// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/lookup.h"
#include "model/reference/probe.h"

namespace feline::reference {

// The filters of CS248A lecture 4 (2025): one probe, whatever the footprint's shape.

// log2 of the longer gradient in texels of level 0 ("Computing mipmap level"); not clamped; -infinity at zero.
double isotropic_level(const MipMap& map, const Lookup& lookup);

// Level 0 only: sharp, and aliased wherever a pixel is larger than a texel.
Colour nearest_filter(const MipMap& map, const Lookup& lookup, Cost& cost);
Colour bilinear_filter(const MipMap& map, const Lookup& lookup, Cost& cost);
Colour bicubic_filter(const MipMap& map, const Cubic& cubic, const Lookup& lookup, Cost& cost);

// The mip level nearest to the level of detail, of two as near the finer ("bilinear filtering only: d clamped to
// nearest level"), and OpenGL's NEAREST_MIPMAP_NEAREST.
Colour nearest_mip_filter(const MipMap& map, const Lookup& lookup, Cost& cost);
Colour bilinear_mip_filter(const MipMap& map, const Lookup& lookup, Cost& cost);

// Two levels blended.
Colour trilinear_filter(const MipMap& map, const Lookup& lookup, Cost& cost);

}  // namespace feline::reference
