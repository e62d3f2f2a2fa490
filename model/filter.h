// SPDX-License-Identifier: Apache-2.0
// filter: eight texels and their fractions to one colour.
//
// Takes  texels U8.4, unit 1/255; fractions U0.8 along x and y of each level; level_fraction U0.8; the kernel.
// Gives  colour U8.28, unit 1/255: exact.
// Rounds nothing: along x U8.4 -> U8.12, along y -> U8.20, between levels -> U8.28. Each step is a convex combination,
//        so the result lies within the texels that have weight, and equal texels come back exactly.
// Edges  gaussian: each fraction is first replaced by the weight of a table; nearest texels take no kernel.
// Source CS248A lecture 4, step 7; WRL 99/1, 3.4 (Gaussian probes, 2 x 2).
#pragma once

#include "tables/roms.h"
#include "tables/sampler_state.h"

namespace feline {

// a at fraction 0, towards b; adds fraction_bits to the fraction of a and b.
constexpr std::int64_t interpolate(std::int64_t a, std::int64_t b, std::int64_t fraction, int fraction_bits) {
  return a * ((std::int64_t{1} << fraction_bits) - fraction) + b * fraction;
}

// Between texels 00, 10, 01, 11 of a level: U8.4 -> U8.20.
template <Config kConfig>
constexpr std::int64_t level_colour(std::int64_t t00, std::int64_t t10, std::int64_t t01, std::int64_t t11,
                                    std::int64_t x, std::int64_t y) {
  constexpr int kSubtexel = kConfig.subtexel_bits;
  return interpolate(interpolate(t00, t10, x, kSubtexel), interpolate(t01, t11, x, kSubtexel), y, kSubtexel);
}

template <Config kConfig>
constexpr bool takes_gaussian(const SamplerState<kConfig>& sampler, bool linear) {
  return kConfig.features.gaussian && static_cast<Kernel>(sampler.kernel.raw()) == Kernel::kGaussian && linear;
}

// The weight of the farther texel at a fraction.
template <Config kConfig>
std::int64_t kernel_weight(std::int64_t fraction, bool gaussian) {
  if (!gaussian) return fraction;
  return static_cast<std::int64_t>(roms<kConfig>().gaussian.words[static_cast<std::size_t>(fraction)]);
}

template <Config kConfig>
FilterBeat<kConfig> filter(const FetchBeat<kConfig>& fetch, const SamplerState<kConfig>& sampler) {
  FilterBeat<kConfig> beat;
  beat.tag = fetch.tag;
  beat.status = fetch.status;
  beat.probe = fetch.probe;
  beat.first = fetch.first;
  beat.last = fetch.last;
  beat.weight = fetch.weight;
  const bool gaussian = takes_gaussian(sampler, fetch.linear.raw() != 0);
  const auto weight_of = [&](const auto& fraction) { return kernel_weight<kConfig>(fraction.raw(), gaussian); };
  const std::int64_t fine_x = weight_of(fetch.fine_fraction_x);
  const std::int64_t fine_y = weight_of(fetch.fine_fraction_y);
  const std::int64_t coarse_x = weight_of(fetch.coarse_fraction_x);
  const std::int64_t coarse_y = weight_of(fetch.coarse_fraction_y);
  for (std::size_t c = 0; c < 4; ++c) {
    const std::int64_t fine = level_colour<kConfig>(fetch.fine_00[c].raw(), fetch.fine_10[c].raw(),
                                                    fetch.fine_01[c].raw(), fetch.fine_11[c].raw(), fine_x, fine_y);
    const std::int64_t coarse =
        level_colour<kConfig>(fetch.coarse_00[c].raw(), fetch.coarse_10[c].raw(), fetch.coarse_01[c].raw(),
                              fetch.coarse_11[c].raw(), coarse_x, coarse_y);
    beat.colour[c] =
        beat.colour[c].from_raw(interpolate(fine, coarse, fetch.level_fraction.raw(), kConfig.level_fraction_bits));
  }
  return beat;
}

}  // namespace feline
