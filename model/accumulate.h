// SPDX-License-Identifier: Apache-2.0
// accumulate: the weighted probes of a pixel to its colour, rounded once.
//
// Takes  colour U8.28, unit 1/255, and weight U1.8 of each probe; first and last.
// Gives  colour U8.8, unit 1/255, with the last probe.
// Rounds the exact weighted sum, U8.36, to 8 fraction bits: nearest, ties up. Weights sum to exactly one, so equal
//        texels come back exactly, and the result lies within the texels that have weight: every texel is a multiple of
//        the result's last bit, and rounding to its multiples is monotone.
// Edges  first starts the sum anew, whatever was there.
// Source WRL 99/1, 3.1 (accumulation), 3.2 (weights that sum to one).
#pragma once

#include <array>
#include <optional>

#include "tables/rounding.h"
#include "tables/sampler_state.h"

namespace feline {

template <Config kConfig>
using Accumulator = std::array<Fixed<Formats<kConfig>::kAccumulated>, 4>;

// The exact weighted sum of a channel, U8.36, to the result's.
template <Config kConfig>
Fixed<Formats<kConfig>::kPixel> round_sum(std::int64_t sum) {
  using F = Formats<kConfig>;
  return Fixed<F::kPixel>::from_raw(round_up_ties(sum, F::kAccumulated.fraction_bits - F::kPixel.fraction_bits));
}

template <Config kConfig>
std::optional<AccumulateBeat<kConfig>> accumulate(const FilterBeat<kConfig>& filter, Accumulator<kConfig>& sum) {
  for (std::size_t c = 0; c < 4; ++c) {
    const std::int64_t carried = filter.first.raw() != 0 ? 0 : sum[c].raw();
    sum[c] = sum[c].from_raw(carried + filter.colour[c].raw() * filter.weight.raw());
  }
  if (filter.last.raw() == 0) return std::nullopt;
  AccumulateBeat<kConfig> beat;
  beat.tag = filter.tag;
  beat.status = filter.status;
  for (std::size_t c = 0; c < 4; ++c) beat.colour[c] = round_sum<kConfig>(sum[c].raw());
  return beat;
}

}  // namespace feline
