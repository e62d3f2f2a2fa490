// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/reference/filters.h"

namespace feline {

// A plane seen at an angle between its normal and the line of sight, by a camera with a field of view of 4.8 degrees:
// what WRL 99/1's figure 35 measures.

// The lookups of side x side pixels, for a texture of this many texels a side, which is turned by `turn` radians on the
// plane. At 0 degrees every pixel is a circle of `radius` texels; elsewhere the middle one's minor radius is that.
std::vector<reference::Lookup> plane_lookups(double degrees, double radius, double turn, int side, int texture_size);

// Means a pixel over viewing distances, evenly spread on a logarithmic scale over an octave, and over turns of the
// texture.
struct AngleCosts {
  double degrees = 0;
  reference::Cost trilinear, texram, high_efficiency, high_quality, ewa;

  // Of the eight texels that a stamp of "Realistic EWA" reads, how many lie outside the ellipse.
  double stamp_texels_outside() const { return 8 - ewa.texels / ewa.stamp_cycles; }
};
AngleCosts measure_costs(double degrees);

}  // namespace feline
