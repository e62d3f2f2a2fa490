// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/sampler_state.h"

namespace feline {

// What a configuration makes of a request for something it leaves out (tables/config.h), and the status bit for it.

template <Config kConfig>
constexpr Mode supported_mode(Mode mode) {
  constexpr Features kFeatures = kConfig.features;
  if (mode == Mode::kExt && !kFeatures.ext) return Mode::kTrilinear;
  if (mode == Mode::kSimple && !kFeatures.simple_feline) return Mode::kTrilinear;
  if (mode == Mode::kTable && !kFeatures.table_feline) return Mode::kTrilinear;
  return mode;
}

template <Config kConfig>
constexpr Wrap supported_wrap(Wrap wrap) {
  if (wrap == Wrap::kMirroredRepeat && !kConfig.features.mirrored_repeat) return Wrap::kRepeat;
  if (wrap == Wrap::kClampToBorder && !kConfig.features.clamp_to_border) return Wrap::kClampToEdge;
  return wrap;
}

template <Config kConfig>
constexpr std::int64_t unsupported_status(const SamplerState<kConfig>& sampler) {
  const auto mode = static_cast<Mode>(sampler.mode.raw());
  const auto wrap_s = static_cast<Wrap>(sampler.wrap_s.raw());
  const auto wrap_t = static_cast<Wrap>(sampler.wrap_t.raw());
  const bool missing = supported_mode<kConfig>(mode) != mode || supported_wrap<kConfig>(wrap_s) != wrap_s ||
                       supported_wrap<kConfig>(wrap_t) != wrap_t ||
                       (sampler.kernel.raw() != 0 && !kConfig.features.gaussian) ||
                       (sampler.srgb.raw() != 0 && !kConfig.features.srgb);
  return missing ? kUnsupported : 0;
}

}  // namespace feline
