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
//        product zero: the axes are the vectors themselves, nothing is turned. All zero: radii 0. A cell of the table
//        that the configuration leaves out: all 0, unsupported.
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

// The gradients of a footprint: the longer one, the length of the other, and their products.
struct Gradients {
  std::int64_t u, v, length;
  bool longer_is_x;
  std::int64_t shorter_length;
  std::int64_t cross, dot;
};

template <Config kConfig>
constexpr Gradients gradients_of(const GroupBeat<kConfig>& group) {
  const std::int64_t dudx = group.dudx.raw();
  const std::int64_t dvdx = group.dvdx.raw();
  const std::int64_t dudy = group.dudy.raw();
  const std::int64_t dvdy = group.dvdy.raw();
  const std::int64_t x_length = vector_length(dudx, dvdx);
  const std::int64_t y_length = vector_length(dudy, dvdy);
  const std::int64_t cross = dudx * dvdy - dvdx * dudy;
  const std::int64_t dot = dudx * dudy + dvdx * dvdy;
  if (x_length > y_length) return {dudx, dvdx, x_length, true, y_length, cross, dot};
  return {dudy, dvdy, y_length, false, x_length, cross, dot};
}

// Where gradients lie in the ellipse table.
struct TableCell {
  std::int64_t row, column;
};

template <Config kConfig>
constexpr TableCell table_cell(const Gradients& gradients) {
  constexpr int kHalf = kConfig.table_columns / 2;
  const std::int64_t cross = std::abs(gradients.cross);
  const std::int64_t dot = std::abs(gradients.dot);
  return {table_index(gradients.shorter_length, gradients.length, kConfig.table_rows),
          cross < dot ? table_index(cross, dot, kHalf) : kHalf + table_index(dot, cross, kHalf)};
}

template <Config kConfig>
void table_footprint(const Gradients& gradients, FootprintBeat<kConfig>& beat) {
  using F = Formats<kConfig>;
  const bool turns = gradients.cross != 0 && gradients.dot != 0;
  const bool counter_clockwise = gradients.longer_is_x ^ (gradients.cross < 0) ^ (gradients.dot < 0);
  const TableCell cell = table_cell<kConfig>(gradients);
  const auto word = static_cast<std::size_t>(cell.row * kConfig.table_columns + cell.column);
  const EllipseEntry entry = ellipse_entry(kConfig, roms<kConfig>().ellipse.words[word]);
  beat.status = beat.status.from_raw(beat.status.raw() | unsupported_if(!kConfig.table_cells.has(word)));
  const std::int64_t turned = turns ? (counter_clockwise ? entry.uv_scale_90 : -entry.uv_scale_90) : 0;
  // uvScale has one fraction bit less than the vector.
  beat.major_u = beat.major_u.from_raw(2 * gradients.u * entry.uv_scale - gradients.v * turned);
  beat.major_v = beat.major_v.from_raw(2 * gradients.v * entry.uv_scale + gradients.u * turned);
  beat.major_radius =
      beat.major_radius.from_raw(round_up_ties(gradients.length * entry.major_radius, F::kTableScale.fraction_bits));
  beat.minor_radius =
      beat.minor_radius.from_raw(round_up_ties(gradients.length * entry.minor_radius, F::kTableFraction.fraction_bits));
}

template <Config kConfig>
FootprintBeat<kConfig> footprint(const GroupBeat<kConfig>& group, const SamplerState<kConfig>& sampler) {
  FootprintBeat<kConfig> beat;
  beat.tag = group.tag;
  beat.s = group.s;
  beat.t = group.t;
  beat.exponent = group.exponent;
  const Mode mode = supported_mode<kConfig>(sampler);
  beat.status = beat.status.from_raw(group.status.raw() | unsupported_status<kConfig>(sampler));

  const Gradients gradients = gradients_of<kConfig>(group);
  if (mode == Mode::kTable) {
    table_footprint<kConfig>(gradients, beat);
    return beat;
  }
  std::int64_t minor = gradients.length;
  if (mode == Mode::kExt) minor = gradients.shorter_length;
  if (mode == Mode::kSimple) {
    const std::int64_t sum = vector_length(group.dudx.raw() + group.dudy.raw(), group.dvdx.raw() + group.dvdy.raw());
    const std::int64_t difference =
        vector_length(group.dudx.raw() - group.dudy.raw(), group.dvdx.raw() - group.dvdy.raw());
    minor = std::min({gradients.shorter_length, sum, difference});
  }
  const std::int64_t one = beat.major_u.kFormatOf.one();
  beat.major_u = beat.major_u.from_raw(gradients.u * one);
  beat.major_v = beat.major_v.from_raw(gradients.v * one);
  beat.major_radius = beat.major_radius.from_raw(gradients.length);
  beat.minor_radius = beat.minor_radius.from_raw(minor);
  return beat;
}

}  // namespace feline
