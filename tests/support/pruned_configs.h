// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/config.h"

namespace feline {

// Units that lack something, each something else.

constexpr Features no_features() {
  Features features;
  for (const FeatureField& each : kFeatureFields) features.*each.field = false;
  return features;
}

// One mode, one wrap, opaque textures of powers of two up to 128, few probes, levels and exponents.
inline constexpr Config kSimpleUnit = [] {
  Config config{.exponent_bits = 3, .max_size_log2 = 7, .guard_bits = 9, .max_probes = 5, .max_levels = 5};
  config.features = no_features();
  for (bool Features::*const each :
       {&Features::simple_feline, &Features::repeat, &Features::rgba8, &Features::level_blend, &Features::linear_texels,
        &Features::dudx, &Features::dvdx, &Features::dudy, &Features::dvdy}) {
    config.features.*each = true;
  }
  return config;
}();

// A table with holes, and rows of weights missing; no sizes but powers of two; nothing else left out.
inline constexpr Config kHoledTableUnit = [] {
  Config config;
  config.features.any_size = false;
  for (auto& bits : config.table_cells.bits) bits = 0xf0f3ffff00ffff7e;
  for (auto& bits : config.weight_rows.bits) bits = 0xfffffff7ffefff2f;
  return config;
}();

// Level by level, unfiltered, of one channel, with clamps and gradients along the axes.
inline constexpr Config kPlainUnit = [] {
  Config config{.max_size_log2 = 8, .guard_bits = 8, .max_probes = 1, .max_levels = 9};
  config.features = no_features();
  for (bool Features::*const each :
       {&Features::nearest, &Features::bilinear, &Features::clamp_to_edge, &Features::clamp_to_border, &Features::r8,
        &Features::srgb, &Features::any_size, &Features::nearest_texels, &Features::dudx, &Features::dvdy}) {
    config.features.*each = true;
  }
  return config;
}();

// Everything along a line that is not Feline, mirrored, in two channels.
inline constexpr Config kExtUnit = [] {
  Config config{.exponent_bits = 4, .max_probes = 16, .max_levels = 12};
  config.features.simple_feline = config.features.table_feline = config.features.gaussian = false;
  config.features.repeat = config.features.clamp_to_edge = config.features.clamp_to_border = false;
  config.features.rgba8 = config.features.level_blend = config.features.srgb = false;
  return config;
}();

// All exponents, without ds/dx and dt/dy, which a footprint without bound needs.
inline constexpr Config kCrossUnit = [] {
  Config config;
  config.features.dudx = config.features.dvdy = false;
  return config;
}();

// Everything but the factors and Gaussian probes.
inline constexpr Config kExactUnit = [] {
  Config config;
  config.features.factors = config.features.gaussian = false;
  return config;
}();

}  // namespace feline
