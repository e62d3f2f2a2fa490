// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tests/support/random.h"
#include "tests/support/samplers.h"

namespace feline {

// dudx, dvdx, dudy, dvdy.
struct Quad {
  std::int64_t dudx, dvdx, dudy, dvdy;
};

inline GroupBeat<kDefaultConfig> group_beat(const Quad& quad, int exponent) {
  GroupBeat<kDefaultConfig> beat;
  beat.exponent = beat.exponent.from_raw(exponent);
  beat.dudx = beat.dudx.from_raw(quad.dudx);
  beat.dvdx = beat.dvdx.from_raw(quad.dvdx);
  beat.dudy = beat.dudy.from_raw(quad.dudy);
  beat.dvdy = beat.dvdy.from_raw(quad.dvdy);
  return beat;
}

inline State state_of(Mode mode) {
  State state;
  state.mode = state.mode.from_raw(static_cast<std::int64_t>(mode));
  return state;
}

inline std::string mode_name(Mode mode) { return std::string(kModeNames[static_cast<std::size_t>(mode)]); }

// Quadruples of every kind, of magnitude up to 127.
inline Quad random_quad(Random& random) {
  const auto any = [&](std::int64_t most) { return random.between(-most, most); };
  const auto near = [&](std::int64_t value) {
    const std::int64_t moved = value + any(2);
    return moved < -127 ? -127 : moved > 127 ? 127 : moved;
  };
  const std::int64_t u = any(127);
  const std::int64_t v = any(127);
  switch (random.below(4)) {
    case 0: return {u, v, any(127), any(127)};
    case 1: return {u, v, any(16), any(16)};
    case 2: {
      const std::int64_t part = random.between(1, 12);
      return {u, v, near(u / part), near(v / part)};
    }
    default: return {u, v, near(-v), near(u)};
  }
}

}  // namespace feline
