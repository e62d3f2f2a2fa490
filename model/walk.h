// SPDX-License-Identifier: Apache-2.0
// walk: one plan to one beat a probe.
//
// Takes  s, t S20.24 and half_step_s, half_step_t S19.24 textures; probes; weight_row.
// Gives  for probe i = 0 .. probes - 1, n = 2i - (probes - 1): position + n * half step, S20.24; its weight U1.8;
//        first and last.
// Rounds nothing. Positions are modulo 2^21, which only the repeats can reach.
// Edges  one probe: the position itself, weight one. A weight row that the configuration leaves out: 0, unsupported.
// Source WRL 99/1, 3.1 (positions, figures 10 and 11), 3.2 (weights: row by fProbes, column floor((|n| + 1)/2)).
#pragma once

#include <cstdlib>

#include "model/features.h"
#include "tables/roms.h"
#include "tables/sampler_state.h"

namespace feline {

template <Config kConfig>
Fixed<Formats<kConfig>::kPosition> probe_position(std::int64_t centre, std::int64_t half_step, std::int64_t n) {
  constexpr int kSpare = 64 - Formats<kConfig>::kPosition.width();
  const auto wrapped = static_cast<std::uint64_t>(centre + n * half_step) << kSpare;
  return Fixed<Formats<kConfig>::kPosition>::from_raw(static_cast<std::int64_t>(wrapped) >> kSpare);
}

// How many half steps a probe is from the centre.
constexpr std::int64_t probe_offset(std::int64_t probe, std::int64_t probes) { return 2 * probe - (probes - 1); }

// The raw weight of the probe n half steps from the centre.
template <Config kConfig>
std::int64_t probe_weight(std::int64_t weight_row, std::int64_t n) {
  const std::int64_t column = (std::abs(n) + 1) / 2;
  const auto word = static_cast<std::size_t>(weight_row * Formats<kConfig>::kWeightColumns + column);
  return static_cast<std::int64_t>(roms<kConfig>().weight.words[word]);
}

// The status, which may complain of the plan's weight row.
template <Config kConfig>
Fixed<Formats<kConfig>::kStatus> row_status(const PlanBeat<kConfig>& plan) {
  const bool has_row = kConfig.weight_rows.has(static_cast<std::size_t>(plan.weight_row.raw()));
  return Fixed<Formats<kConfig>::kStatus>::from_raw(plan.status.raw() | unsupported_if(!has_row));
}

template <Config kConfig>
WalkBeat<kConfig> walk(const PlanBeat<kConfig>& plan, std::int64_t probe) {
  WalkBeat<kConfig> beat;
  beat.tag = plan.tag;
  beat.level_of_detail = plan.level_of_detail;
  beat.linear = plan.linear;
  beat.probe = beat.probe.from_raw(probe);
  beat.first = beat.first.from_raw(probe == 0);
  beat.last = beat.last.from_raw(probe == plan.probes.raw() - 1);
  const std::int64_t n = probe_offset(probe, plan.probes.raw());
  beat.s = probe_position<kConfig>(plan.s.raw(), plan.half_step_s.raw(), n);
  beat.t = probe_position<kConfig>(plan.t.raw(), plan.half_step_t.raw(), n);
  beat.status = row_status<kConfig>(plan);
  beat.weight = beat.weight.from_raw(probe_weight<kConfig>(plan.weight_row.raw(), n));
  return beat;
}

}  // namespace feline
