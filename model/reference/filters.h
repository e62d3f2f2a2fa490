// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/reference/lookup.h"
#include "model/reference/mip_map.h"
#include "model/reference/probe.h"
#include "model/reference/vertex_based.h"

namespace feline::reference {

// The pyramids of filtered images that a filter may ask for.
struct Images {
  MipMap lanczos;  // mip levels by a Lanczos filter of radius 3, for all but EWA and RIP mapping (WRL 99/1, section 4)
  MipMap box;      // by a box filter, for EWA
  RipMap rip;      // by Lanczos, each direction on its own
};

// One of these.
enum class Pyramid : std::uint8_t { kLanczos, kBox, kRip };

// What a filter is told of a pixel: the lookup, and what rasterising the surface's mesh adds to it.
struct Pixel {
  Lookup lookup;
  Lookup polygon_middle;   // of the polygon that covers it, for RIP mapping by polygon
  Gradients<double> axes;  // vertex_axes, interpolated, for vertex-based texturing
};

// A filter of the papers. Calls from several threads are safe.
struct Filter {
  std::string name;
  std::string_view description;
  std::string_view source;                // paper and section
  std::optional<AxisSystem> axis_system;  // which axes it wants in Pixel::axes
  std::function<Colour(const Images& images, const Pixel& pixel, Cost& cost)> run;
  Pyramid pyramid = Pyramid::kLanczos;  // the only one that it reads
};

// All of them, from the plainest to EWA.
std::span<const Filter> filters();

// Null for a name that is none of theirs.
const Filter* find_filter(std::string_view name);

}  // namespace feline::reference
