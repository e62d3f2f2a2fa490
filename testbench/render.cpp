// SPDX-License-Identifier: Apache-2.0
#include "testbench/render.h"

#include <type_traits>

#include "testbench/progress.h"

namespace feline {
namespace {

// `sample` makes the pixel of a request and calls a trace with its plan, at least.
template <typename Sample>
Picture render(const GBuffer& gbuffer, bool srgb, Sample sample) {
  Picture picture{gbuffer.width, gbuffer.height, srgb, {}, {}};
  picture.pixels.reserve(gbuffer.lookups.size());
  picture.plans.reserve(gbuffer.lookups.size());
  Progress progress("rendering", gbuffer.lookups.size());
  const auto keep = [&]<typename Beat>(const Beat& beat) {
    if constexpr (std::is_same_v<Beat, PlanBeat<kDefaultConfig>>) picture.plans.push_back(beat);
  };
  for (const Lookup& lookup : gbuffer.lookups) {
    picture.pixels.push_back(sample(make_request<kDefaultConfig>(lookup, 0), keep));
    progress.advance(1);
  }
  return picture;
}

template <LineSource Lines>
Picture render_by(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler, Lines& lines,
                  ShortcutCounts& counts, const Shortcuts& shortcuts) {
  ShortcutUnit<kDefaultConfig, Lines> unit(sampler, lines, shortcuts);
  Picture picture = render(gbuffer, sampler.srgb.raw() != 0,
                           [&](const auto& request, const auto& trace) { return unit.sample(request, trace); });
  counts = unit.counts();
  return picture;
}

}  // namespace

Picture render_model(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory) {
  return render(gbuffer, sampler.srgb.raw() != 0, [&](const auto& request, const auto& trace) {
    return sample<kDefaultConfig>(request, sampler, memory, trace);
  });
}

Picture render_shortcuts(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler,
                         const TextureMemory& memory, ShortcutCounts& counts, const Shortcuts& shortcuts) {
  return render_by(gbuffer, sampler, memory, counts, shortcuts);
}

Picture render_shortcuts(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler, LazyTexture& texture,
                         ShortcutCounts& counts, const Shortcuts& shortcuts) {
  return render_by(gbuffer, sampler, texture, counts, shortcuts);
}

}  // namespace feline
