// SPDX-License-Identifier: Apache-2.0
// footprint: four mantissas to the major vector and both radii of the pixel's footprint.
//
// Takes  dudx, dvdx, dudy, dvdy S7.0 texel * 2^exponent; the mode.
// Gives  major_u, major_v S8.8 and major_radius, minor_radius U8.7, texel * 2^exponent.
//        nearest, bilinear, trilinear: both radii are the longer vector's length.
//        ext: the longer and the shorter length. simple: the longer length; the shortest of sides and diagonals.
//        table: the ellipse, through its table.
// Rounds lengths are exact; table: major_u, major_v are exact, both radii nearest, ties up.
// Edges  Equal lengths: y is the long vector. A zero shorter vector: ratio 0, column of 90 degrees. Cross or dot
//        product zero: the axes are the vectors themselves, nothing is turned. All zero: radii 0.
// Source WRL 99/1, 3.2 (lengths, Simple), 3.3 (Table, its rotation corrected: a counter-clockwise turn by 90 degrees
//        takes (u, v) to (-v, u)); EXT_texture_filter_anisotropic.
//        Where 3.2 chooses a part of the length by b < 3a/8, the larger part is taken here: with the choice, (120, 44)
//        is longer than (120, 45), and a growing footprint could get a lower level of detail. The parts cross at
//        b = 19a/50, and the extremes of the error, +1.213 % and -1.116 %, stay the paper's.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "model/features.h"
#include "tables/roms.h"
#include "tables/rounding.h"
#include "tables/sampler_state.h"

namespace feline {

// The length of (a, b) in units of 1/128, exact: max(a + 5b/32, 109a/128 + 35b/64), a >= b >= 0.
constexpr std::int64_t vector_length(std::int64_t u, std::int64_t v) {
  const std::int64_t a = std::max(u < 0 ? -u : u, v < 0 ? -v : v);
  const std::int64_t b = std::min(u < 0 ? -u : u, v < 0 ? -v : v);
  return std::max(128 * a + 20 * b, 109 * a + 70 * b);
}

// floor(steps * numerator / denominator), at most steps - 1; a denominator of 0 gives 0.
constexpr std::int64_t table_index(std::int64_t numerator, std::int64_t denominator, int steps) {
  if (denominator == 0) return 0;
  return std::min<std::int64_t>(steps * numerator / denominator, steps - 1);
}

template <Config kConfig>
struct LongVector {
  std::int64_t u, v, length;
  bool is_x;
};

template <Config kConfig>
void table_footprint(const LongVector<kConfig>& longer, std::int64_t shorter_length, std::int64_t cross,
                     std::int64_t dot, FootprintBeat<kConfig>& beat) {
  using F = Formats<kConfig>;
  constexpr int kHalf = kConfig.table_columns / 2;
  const bool turns = cross != 0 && dot != 0;
  const bool counter_clockwise = longer.is_x ^ (cross < 0) ^ (dot < 0);
  const std::int64_t cross_size = std::abs(cross);
  const std::int64_t dot_size = std::abs(dot);
  const std::int64_t row = table_index(shorter_length, longer.length, kConfig.table_rows);
  const std::int64_t column = cross_size < dot_size ? table_index(cross_size, dot_size, kHalf)
                                                    : kHalf + table_index(dot_size, cross_size, kHalf);
  const EllipseEntry entry = ellipse_entry(
      kConfig, roms<kConfig>().ellipse.words[static_cast<std::size_t>(row * kConfig.table_columns + column)]);
  const std::int64_t turned = turns ? (counter_clockwise ? entry.uv_scale_90 : -entry.uv_scale_90) : 0;
  // uvScale has one fraction bit less than the vector.
  beat.major_u = beat.major_u.from_raw(2 * longer.u * entry.uv_scale - longer.v * turned);
  beat.major_v = beat.major_v.from_raw(2 * longer.v * entry.uv_scale + longer.u * turned);
  beat.major_radius =
      beat.major_radius.from_raw(round_up_ties(longer.length * entry.major_radius, F::kTableScale.fraction_bits));
  beat.minor_radius =
      beat.minor_radius.from_raw(round_up_ties(longer.length * entry.minor_radius, F::kTableFraction.fraction_bits));
}

template <Config kConfig>
FootprintBeat<kConfig> footprint(const GroupBeat<kConfig>& group, const SamplerState<kConfig>& sampler) {
  FootprintBeat<kConfig> beat;
  beat.tag = group.tag;
  beat.s = group.s;
  beat.t = group.t;
  beat.exponent = group.exponent;
  const Mode wanted = static_cast<Mode>(sampler.mode.raw());
  const Mode mode = supported_mode<kConfig>(wanted);
  beat.status = beat.status.from_raw(group.status.raw() | unsupported_status<kConfig>(sampler));

  const std::int64_t dudx = group.dudx.raw();
  const std::int64_t dvdx = group.dvdx.raw();
  const std::int64_t dudy = group.dudy.raw();
  const std::int64_t dvdy = group.dvdy.raw();
  const std::int64_t x_length = vector_length(dudx, dvdx);
  const std::int64_t y_length = vector_length(dudy, dvdy);
  const bool x_is_longer = x_length > y_length;
  const LongVector<kConfig> longer =
      x_is_longer ? LongVector<kConfig>{dudx, dvdx, x_length, true} : LongVector<kConfig>{dudy, dvdy, y_length, false};
  const std::int64_t shorter_length = x_is_longer ? y_length : x_length;

  if (mode == Mode::kTable) {
    const std::int64_t cross = dudx * dvdy - dvdx * dudy;
    const std::int64_t dot = dudx * dudy + dvdx * dvdy;
    table_footprint<kConfig>(longer, shorter_length, cross, dot, beat);
    return beat;
  }
  std::int64_t minor = longer.length;
  if (mode == Mode::kExt) minor = shorter_length;
  if (mode == Mode::kSimple) {
    minor =
        std::min({shorter_length, vector_length(dudx + dudy, dvdx + dvdy), vector_length(dudx - dudy, dvdx - dvdy)});
  }
  const std::int64_t one = beat.major_u.kFormatOf.one();
  beat.major_u = beat.major_u.from_raw(longer.u * one);
  beat.major_v = beat.major_v.from_raw(longer.v * one);
  beat.major_radius = beat.major_radius.from_raw(longer.length);
  beat.minor_radius = beat.minor_radius.from_raw(minor);
  return beat;
}

}  // namespace feline
