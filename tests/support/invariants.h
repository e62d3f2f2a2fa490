// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "model/unit.h"
#include "tests/support/lookups.h"
#include "tests/support/samplers.h"

namespace feline {

using Pixel = AccumulateBeat<kDefaultConfig>;

// What one lookup did, seen at the boundaries only.
struct Observation {
  GroupBeat<kDefaultConfig> group;
  FootprintBeat<kDefaultConfig> footprint;
  PlanBeat<kDefaultConfig> plan;
  std::int64_t probes = 0;
  std::int64_t weights = 0;
  std::array<std::int64_t, 4> low{}, high{};  // over the texels that it touched, unit 1/(255 * 16)
  Pixel pixel;

  void operator()(const RequestBeat<kDefaultConfig>&) {
    low.fill(1 << 20);
    high.fill(-1);
  }
  void operator()(const GroupBeat<kDefaultConfig>& beat) { group = beat; }
  void operator()(const FootprintBeat<kDefaultConfig>& beat) { footprint = beat; }
  void operator()(const PlanBeat<kDefaultConfig>& beat) { plan = beat; }
  void operator()(const WalkBeat<kDefaultConfig>& beat) {
    ++probes;
    weights += beat.weight.raw();
  }
  void operator()(const AddressBeat<kDefaultConfig>& beat) { coarse_used_ = beat.coarse_used.raw() != 0; }
  void operator()(const FetchBeat<kDefaultConfig>& beat) {
    for (const auto* texel : {&beat.fine_00, &beat.fine_10, &beat.fine_01, &beat.fine_11}) touch(*texel);
    if (!coarse_used_) return;
    for (const auto* texel : {&beat.coarse_00, &beat.coarse_10, &beat.coarse_01, &beat.coarse_11}) touch(*texel);
  }
  void operator()(const FilterBeat<kDefaultConfig>&) {}
  void operator()(const Pixel& beat) { pixel = beat; }

 private:
  void touch(const FetchBeat<kDefaultConfig>::Texel& texel) {
    for (std::size_t c = 0; c < 4; ++c) {
      low[c] = std::min(low[c], texel[c].raw());
      high[c] = std::max(high[c], texel[c].raw());
    }
  }
  bool coarse_used_ = false;
};

inline Observation observe(const Lookup& lookup, const State& state, const TestScene& scene, std::int64_t tag = 0) {
  Observation seen;
  sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, tag), state, scene.memory, seen);
  return seen;
}

// The level of detail before bias and clamps, from the chosen state but for its own bias, clamps and chain.
inline std::int64_t level_before_clamps(const FootprintBeat<kDefaultConfig>& footprint, const State& state) {
  const Mode mode = static_cast<Mode>(state.mode.raw());
  const auto radii = clamp_radii<kDefaultConfig>(footprint, mode, state.length_factor.raw());
  const auto choice = choose_probes<kDefaultConfig>(radii, mode, state);
  const auto fitted = fit_minor_radius<kDefaultConfig>(radii, mode, choice, state);
  return level_of_radius<kDefaultConfig>(fitted, footprint.exponent.raw()).raw();
}

inline const TestScene& pick(Random& random, const std::vector<TestScene>& scenes) {
  return scenes[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())))];
}

inline Lookup lookup_into(Random& random, const TestScene& scene) {
  return any_lookup(random, scene.texture.levels[0].width, scene.texture.levels[0].height);
}

inline State state_into(const SamplerOptions& options, const TestScene& scene) {
  return make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
}

}  // namespace feline
