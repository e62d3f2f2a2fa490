// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/reference/lookup.h"
#include "model/reference/probe.h"

namespace feline::reference {

// Vertex-based anisotropic texturing (Olano, Mukherjee, Dorbie 2001): one pass of ordinary trilinear mip-mapping a
// probe, each with the texture coordinates moved by offsets that are computed at vertices and interpolated, and with a
// bias of the level of detail; passes are blended.

// Table 2: the two axes of the domain in which probes are placed.
enum class AxisSystem : std::uint8_t { kEllipse, kScreen, kMax };

// The axes at a vertex: x is axis 1, y axis 2, normalized as the gradients are. Lengths are compared in texels of
// `base`.
Gradients<double> vertex_axes(AxisSystem system, const Gradients<double>& normalized, const Level& base);

// Probes in the unit circle (section 2.1), their weights exp(-2 r^2), normalized.
struct ProbePattern {
  std::vector<Vector2<double>> probes;
  std::vector<double> weights;
  double spacing = 1;  // between neighbours; the bias of the level of detail is log2 of it, as a mip probe's own is 1
};
ProbePattern line_pattern(int probes);         // along axis 1, evenly spread, set in by a spacing at its ends
ProbePattern square_pattern(int side_probes);  // the same in both directions; 2: the corners of a square
ProbePattern staggered_pattern();              // eight probes in three rows, 3 - 2 - 3 (figure 4f)

// The alpha of each pass, from the last probe back (table 1): alphas[k] = w[k] / (w[0] + ... + w[k]).
std::vector<double> blend_alphas(std::span<const double> weights);

// `axes`: as vertex_axes, interpolated to the pixel.
Colour vertex_based_filter(const MipMap& map, const ProbePattern& pattern, std::span<const double> alphas,
                           const Gradients<double>& axes, const Lookup& lookup, Cost& cost);

}  // namespace feline::reference
