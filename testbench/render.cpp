// SPDX-License-Identifier: Apache-2.0
#include "testbench/render.h"

#include "testbench/progress.h"

namespace feline {

Picture render_model(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory) {
  Picture picture{gbuffer.width, gbuffer.height, sampler.srgb.raw() != 0, {}, {}};
  Progress progress("rendering", gbuffer.lookups.size());
  for (const Lookup& lookup : gbuffer.lookups) {
    picture.pixels.push_back(sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler, memory,
                                                    [&]<typename Beat>(const Beat& beat) {
                                                      if constexpr (std::is_same_v<Beat, PlanBeat<kDefaultConfig>>) {
                                                        picture.plans.push_back(beat);
                                                      }
                                                    }));
    progress.advance(1);
  }
  return picture;
}

}  // namespace feline
