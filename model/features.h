// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/sampler_state.h"
#include "tables/supported.h"

namespace feline {

// What a configuration makes of a request for something it leaves out (tables/config.h), and the status bit for it.

template <Config kConfig>
constexpr Mode supported_mode(const SamplerState<kConfig>& sampler) {
  return supported_mode(kConfig.features, static_cast<Mode>(sampler.mode.raw()));
}

template <Config kConfig>
constexpr Wrap supported_wrap(const Fixed<Formats<kConfig>::kWrap>& wrap) {
  return supported_wrap(kConfig.features, static_cast<Wrap>(wrap.raw()));
}

template <Config kConfig>
constexpr TexelFormat supported_format(const SamplerState<kConfig>& sampler) {
  return supported_format(kConfig.features, static_cast<TexelFormat>(sampler.texel_format.raw()));
}

// Of a configuration without factors everything is exact: the rounding of 3.1, a lengthFactor of 1.
template <Config kConfig>
constexpr bool rounds_up(const SamplerState<kConfig>& sampler) {
  return kConfig.features.factors &&
         static_cast<ProbeRounding>(sampler.probe_rounding.raw()) == ProbeRounding::kCeiling;
}

template <Config kConfig>
constexpr std::int64_t supported_length_factor(const SamplerState<kConfig>& sampler) {
  return kConfig.features.factors ? sampler.length_factor.raw() : Formats<kConfig>::kFactor.one();
}

// The status bit of a lookup that asks for what is left out, or 0.
constexpr std::int64_t unsupported_if(bool missing) { return missing ? kUnsupported : 0; }

// What the sampler state alone asks for.
template <Config kConfig>
constexpr std::int64_t unsupported_status(const SamplerState<kConfig>& sampler) {
  constexpr Features kFeatures = kConfig.features;
  const auto has_its_wrap = [](const auto& wrap) { return has_wrap(kConfig.features, static_cast<Wrap>(wrap.raw())); };
  const bool factored = static_cast<ProbeRounding>(sampler.probe_rounding.raw()) == ProbeRounding::kCeiling ||
                        sampler.length_factor.raw() != Formats<kConfig>::kFactor.one();
  return unsupported_if(!has_mode(kFeatures, static_cast<Mode>(sampler.mode.raw())) || !has_its_wrap(sampler.wrap_s) ||
                        !has_its_wrap(sampler.wrap_t) ||
                        !has_format(kFeatures, static_cast<TexelFormat>(sampler.texel_format.raw())) ||
                        (sampler.kernel.raw() != 0 && !kFeatures.gaussian) ||
                        (sampler.srgb.raw() != 0 && !kFeatures.srgb) || (factored && !kFeatures.factors));
}

}  // namespace feline
