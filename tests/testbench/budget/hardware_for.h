// SPDX-License-Identifier: Apache-2.0
// The unit that a candidate needs for a scene's first frame.
#pragma once

#include <array>
#include <vector>

#include "testbench/budget/candidate.h"
#include "testbench/measure/contestant.h"
#include "testbench/measure/exhibit.h"

namespace feline {

inline Config hardware_for(const Exhibit& exhibit, const Candidate& candidate) {
  const Surface& surface = *exhibit.surface;
  const auto sampler = make_sampler<kDefaultConfig>(sampler_options(candidate), surface.texture, surface.memory);
  const std::vector<Lookup>& lookups = exhibit.frames.front().gbuffer.lookups;
  std::vector<std::array<float, 4>> colours(lookups.size());
  VariantUse use;
  variant_of(candidate.widths).sample(sampler, surface.memory, lookups, colours, use);
  return hardware_of(candidate, sampler, use);
}

}  // namespace feline
