// SPDX-License-Identifier: Apache-2.0
// accumulate: the weighted probes of a pixel to its colour, rounded once.
//
// Takes  colour U8.28, unit 1/255, and weight U1.8 of each probe; first and last.
// Gives  colour U8.8, unit 1/255, with the last probe; the status bits of all probes.
// Rounds the exact weighted sum, U8.36, to 8 fraction bits: nearest, ties up. Weights sum to exactly one, so equal
//        texels come back exactly, and the result lies within the texels that have weight: every texel is a multiple of
//        the result's last bit, and rounding to its multiples is monotone.
// Edges  first starts the sum anew, whatever was there. A channel that the configuration leaves out is 0, alpha one,
//        even where weights are missing.
// Source WRL 99/1, 3.1 (accumulation), 3.2 (weights that sum to one).
#pragma once

#include <array>
#include <optional>

#include "tables/rounding.h"
#include "tables/sampler_state.h"
#include "tables/supported.h"

namespace feline {

template <Config kConfig>
struct Accumulator {
  std::array<Fixed<Formats<kConfig>::kAccumulated>, 4> colour;
  Fixed<Formats<kConfig>::kStatus> status;
};

// The exact weighted sum of a channel, U8.36, to the result's.
template <Config kConfig>
Fixed<Formats<kConfig>::kPixel> round_sum(std::int64_t sum) {
  using F = Formats<kConfig>;
  return Fixed<F::kPixel>::from_raw(round_up_ties(sum, F::kAccumulated.fraction_bits - F::kPixel.fraction_bits));
}

// A channel from its exact weighted sum. One that the configuration has no place for is 0, alpha one, whatever the
// weights.
template <Config kConfig>
Fixed<Formats<kConfig>::kPixel> finished_channel(std::size_t channel, std::int64_t sum) {
  using Pixel = Fixed<Formats<kConfig>::kPixel>;
  if (has_channel(kConfig.features, static_cast<int>(channel))) return round_sum<kConfig>(sum);
  return channel == 3 ? Pixel::from_raw(std::int64_t{255} << kConfig.pixel_fraction_bits) : Pixel{};
}

template <Config kConfig>
std::optional<AccumulateBeat<kConfig>> accumulate(const FilterBeat<kConfig>& filter, Accumulator<kConfig>& sum) {
  const bool first = filter.first.raw() != 0;
  for (std::size_t c = 0; c < 4; ++c) {
    const std::int64_t carried = first ? 0 : sum.colour[c].raw();
    sum.colour[c] = sum.colour[c].from_raw(carried + filter.colour[c].raw() * filter.weight.raw());
  }
  sum.status = sum.status.from_raw((first ? 0 : sum.status.raw()) | filter.status.raw());
  if (filter.last.raw() == 0) return std::nullopt;
  AccumulateBeat<kConfig> beat;
  beat.tag = filter.tag;
  beat.status = sum.status;
  for (std::size_t c = 0; c < 4; ++c) beat.colour[c] = finished_channel<kConfig>(c, sum.colour[c].raw());
  return beat;
}

}  // namespace feline
