// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "model/lookup.h"
#include "tests/support/floats.h"

namespace feline {

// As a renderer makes them: footprints of 1/4 to 64 texels of a width x height texture, up to 32 : 1, at any angle.
inline Lookup tame_lookup(Random& random, int width, int height) {
  const double angle = random.real(0, 6.283185307179586);
  const double skew = random.one_in(2) ? 1.5707963267948966 : random.real(0.05, 3.09);
  const double longer = std::exp2(random.real(-2, 6));
  const double shorter = longer * std::exp2(-random.real(0, 5));
  const bool swap = random.one_in(2);
  const double x = swap ? shorter : longer;
  const double y = swap ? longer : shorter;
  return {static_cast<float>(random.real(-2, 3)),
          static_cast<float>(random.real(-2, 3)),
          static_cast<float>(x * std::cos(angle) / width),
          static_cast<float>(x * std::sin(angle) / height),
          static_cast<float>(y * std::cos(angle + skew) / width),
          static_cast<float>(y * std::sin(angle + skew) / height)};
}

// Aimed at the edges of the arithmetic: small integers of texels, ties, equal lengths, parallel and right-angled
// vectors, zero vectors, coordinates on texel edges and centres.
inline Lookup directed_lookup(Random& random, int width, int height) {
  const auto texels = [&] {
    const double steps = static_cast<double>(random.between(-130, 130));
    return std::ldexp(random.one_in(6) ? 0 : steps, static_cast<int>(random.between(-9, 3)));
  };
  double ux = texels();
  double vx = texels();
  double uy = texels();
  double vy = texels();
  switch (random.below(8)) {
    case 0: uy = -vx, vy = ux; break;         // a circle
    case 1: uy = vx, vy = ux; break;          // equal lengths
    case 2: uy = ux / 4, vy = vx / 4; break;  // parallel
    case 3: uy = vy = 0; break;
    case 4: ux = vx = 0; break;
    case 5: vx = uy = 0; break;
    case 6: uy = -vx / 16, vy = ux / 16; break;
    default: break;
  }
  const auto coordinate = [&](int size) {
    return static_cast<float>(static_cast<double>(random.between(-4 * size, 8 * size)) / (2.0 * size));
  };
  return {coordinate(width),
          coordinate(height),
          static_cast<float>(ux / width),
          static_cast<float>(vx / height),
          static_cast<float>(uy / width),
          static_cast<float>(vy / height)};
}

// Every class of float in every operand.
inline Lookup wild_lookup(Random& random) {
  return {any_float(random), any_float(random), any_float(random),
          any_float(random), any_float(random), any_float(random)};
}

inline Lookup any_lookup(Random& random, int width, int height) {
  switch (random.below(4)) {
    case 0: return wild_lookup(random);
    case 1: return directed_lookup(random, width, height);
    case 2: {  // one operand of any class in a tame one
      Lookup lookup = tame_lookup(random, width, height);
      float* const operands[] = {&lookup.s, &lookup.t, &lookup.dsdx, &lookup.dtdx, &lookup.dsdy, &lookup.dtdy};
      *operands[random.below(6)] = any_float(random);
      return lookup;
    }
    default: return tame_lookup(random, width, height);
  }
}

}  // namespace feline
