// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "tests/support/radius_bounds.h"

namespace feline {

// The most, in octaves, by which the level of detail (before bias and clamps) can fall when all four derivatives are
// multiplied by the same factor >= 1 (invariant 5). Proof, with M >= m the real radii, M' and m' the stored ones, p the
// largest probe count, R = max(m, one texel, 2/(p + 1) lengthFactor M), which only grows, R' the same of the stored
// radii:
//
// - R'/R lies within ratios.low() .. ratios.high(): each part of the maximum does. Those of the effective radius
//   were found for lengthFactor 0.9625, the least of the paper's sets, and p = 16; they hold where 2/(p + 1)
//   lengthFactor is larger. Where it is smaller, R' lies between that part of M' and M' (or is one texel), and M' falls
//   by no more than the major ratios: R' falls by no more than both together.
// - plan's fitted radius is at least `least` R' and at most `most` R':
//   nearest: max(m', w), w = 2M'/(N + 1), N = floor(2M'/m' - 1/2) within 1 .. p: w <= 5/4 m' (at N = 1) unless N = p is
//   a limit, when w is R' itself.
//   ceiling, N + 1 = ceil(2fM'/m'), f = 1/(blurFactor aliasFactor): not limited, min(w, blurFactor m'), where N >= 2
//   has w >= m'/(3/2 f) and R' <= max(m', m'/f); limited, R'/aliasFactor.
// - One texel when M' is smaller: the radius is M', which lies below R' and grows within the major ratios.
//
// ext: both lengths only grow, as group rounds outward and the length is monotonic. M/N with N = ceil(M/m) is at most m
// and at least M/(M/m + 1) = 1/(1/m + 1/M), which grows; so a fall is at most m (1/m + 1/M) <= 2: one octave, from N =
// 1 to 2. A limited N only keeps M/N larger. The isotropic modes have nothing but a monotonic length and fall by
// nothing at all.
inline double fall_bound(const State& state) {
  const Mode mode = static_cast<Mode>(state.mode.raw());
  if (mode == Mode::kNearest || mode == Mode::kBilinear || mode == Mode::kTrilinear) return 0;
  // Roundings of the radius, at most two of its units of at least 463 on either side; of its 9 significant bits, 2^-9;
  // of the logarithm, 1/512 octave.
  constexpr double kRounding = 2 * (0.0063 + 0.0029 + 0.002);
  if (mode == Mode::kExt) return 1 + kRounding;
  const RatioBounds& ratios = mode == Mode::kSimple ? kSimpleRatios : kTableRatios;
  double least = 1;
  double most = 1.25;
  if (static_cast<ProbeRounding>(state.probe_rounding.raw()) == ProbeRounding::kCeiling) {
    const double f = state.probe_factor.value();
    most = state.blur_factor.value();
    least = std::min({1.0, 2 / (3 * f), most * f, state.inverse_alias_factor.value()});
  }
  const double least_line = 2.0 / (static_cast<double>(state.max_probes.raw()) + 1) * state.length_factor.value();
  const double radius = least_line >= kLeastLine * (1 - 1e-12) ? ratios.high() / ratios.low()
                                                               : ratios.major_high / ratios.major_low / least_line;
  return std::log2(radius * most / least) + kRounding;
}

}  // namespace feline
