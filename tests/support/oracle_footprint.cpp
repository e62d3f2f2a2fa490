// SPDX-License-Identifier: Apache-2.0
// group and footprint.
#include <algorithm>
#include <cmath>

#include "tests/support/oracle.h"

namespace feline::oracle {
namespace {

constexpr Wide power(int exponent) { return Wide{1} << exponent; }

bool is_nan(std::int64_t bits) { return (bits & 0x7fffffff) > 0x7f800000; }
bool is_finite(std::int64_t bits) { return (bits & 0x7f800000) != 0x7f800000; }

// |x| = significand * 2^exponent; denormals are 0.
struct Magnitude {
  Wide significand = 0;
  int exponent = 0;
};

Magnitude magnitude_of(std::int64_t bits) {
  const auto biased = static_cast<int>(bits / power(23) % 256);
  if (biased == 0) return {};
  return {power(23) + bits % power(23), biased - 150};
}

std::int64_t position_of(std::int64_t bits, std::int64_t wrap) {
  const bool clamps = wrap >= 2;
  const bool negative = bits >= power(31);
  if (is_nan(bits)) return 0;
  if (!is_finite(bits) && !clamps) return 0;
  const Magnitude x = magnitude_of(bits);
  const int shift = x.exponent + 24;
  Wide units = 0;
  if (shift >= 45) {
    units = clamps ? power(43) : 0;  // a multiple of 2^21 textures
  } else if (shift >= 0) {
    units = x.significand * power(shift);
  } else {
    units = shift < -60 ? 0 : nearest_away({x.significand, power(-shift)});
  }
  if (clamps) units = std::min(units, power(43));
  if (negative) units = -units;
  const Wide turn = power(45);
  Wide left = (units % turn + turn) % turn;
  if (left >= turn / 2) left -= turn;
  return static_cast<std::int64_t>(left);
}

// significand * 2^(exponent - unit) as an integer: the nearest, ties away from zero, or the least that is not below.
Wide rounded(const Magnitude& x, int unit, bool nearest) {
  const int shift = unit - x.exponent;
  if (x.significand == 0) return 0;
  if (shift > 100) return nearest ? 0 : 1;
  if (shift < 0) return x.significand * power(-shift);
  return nearest ? nearest_away({x.significand, power(shift)}) : ceil_of({x.significand, power(shift)});
}

// The larger part of the two-part linear length, in 1/128: of a + 5b/32 and 109a/128 + 35b/64.
Wide length_of(Wide u, Wide v) {
  const Wide a = std::max(u * (u < 0 ? -1 : 1), v * (v < 0 ? -1 : 1));
  const Wide b = std::min(u * (u < 0 ? -1 : 1), v * (v < 0 ? -1 : 1));
  return std::max(a * 128 + b * (5 * 128 / 32), a * 109 + b * (35 * 2));
}

// The last step, of `steps`, that does not lie beyond part/whole.
std::size_t step_of(Wide part, Wide whole, int steps) {
  int step = 0;
  while (step + 1 < steps && whole > 0 && (step + 1) * whole <= steps * part) ++step;
  return static_cast<std::size_t>(step);
}

}  // namespace

Wide floor_of(const Rational& x) {
  const Wide quotient = x.numerator / x.denominator;
  return quotient * x.denominator > x.numerator ? quotient - 1 : quotient;
}
Wide ceil_of(const Rational& x) { return -floor_of({-x.numerator, x.denominator}); }
Wide nearest_up(const Rational& x) { return floor_of({2 * x.numerator + x.denominator, 2 * x.denominator}); }
Wide nearest_away(const Rational& x) {
  return x.numerator < 0 ? -nearest_up({-x.numerator, x.denominator}) : nearest_up(x);
}

Group group(const Request& request, const State& state) {
  Group beat;
  beat.tag = request.tag;
  set(beat.s, position_of(request.s.raw(), state.wrap_s.raw()));
  set(beat.t, position_of(request.t.raw(), state.wrap_t.raw()));
  const std::array derivative{request.dsdx.raw(), request.dtdx.raw(), request.dsdy.raw(), request.dtdy.raw()};
  const bool bounded = std::all_of(derivative.begin(), derivative.end(), is_finite);
  // A clamp cannot tell coordinates from 2^19 on apart.
  const auto saturates = [](std::int64_t bits, std::int64_t wrap) {
    const Magnitude size = magnitude_of(bits);
    if (!is_finite(bits) || wrap < 2 || size.significand == 0 || size.exponent < -24) return false;
    return size.exponent >= 0 || size.significand / power(-size.exponent) >= power(19);
  };
  bool overflow = saturates(request.s.raw(), state.wrap_s.raw()) || saturates(request.t.raw(), state.wrap_t.raw());
  const int not_finite = (is_finite(request.s.raw()) && is_finite(request.t.raw()) ? 0 : 1) + (bounded ? 0 : 2);
  set(beat.status, not_finite + (overflow ? 8 : 0));
  if (!bounded) {
    set(beat.exponent, 63);
    set(beat.dudx, 127);
    set(beat.dvdy, 127);
    return beat;
  }
  std::array<Magnitude, 4> texels;
  int unit = -1000;
  for (std::size_t i = 0; i < 4; ++i) {
    texels[i] = magnitude_of(derivative[i]);
    texels[i].significand *= i % 2 == 0 ? state.width.raw() : state.height.raw();
    // Below any unit that could do: some mantissa would have 16 bits or more.
    if (texels[i].significand != 0) unit = std::max(unit, texels[i].exponent);
  }
  const bool nearest = state.mode.raw() >= 4;  // simple, table
  // The finest unit in which all four fit 7 bits.
  const auto fits = [&] {
    return std::all_of(texels.begin(), texels.end(),
                       [&](const Magnitude& x) { return rounded(x, unit, nearest) <= 127; });
  };
  while (!fits()) ++unit;
  overflow = overflow || unit > 63;
  set(beat.status, not_finite + (overflow ? 8 : 0));
  set(beat.exponent, std::clamp(unit, -64, 63));
  if (unit < -64) return beat;
  const auto signed_mantissa = [&](std::size_t i) {
    const Wide size = rounded(texels[i], unit, nearest);
    return derivative[i] >= power(31) ? -size : size;
  };
  set(beat.dudx, signed_mantissa(0));
  set(beat.dvdx, signed_mantissa(1));
  set(beat.dudy, signed_mantissa(2));
  set(beat.dvdy, signed_mantissa(3));
  return beat;
}

Footprint footprint(const Group& group, const State& state) {
  Footprint beat;
  beat.tag = group.tag;
  beat.status = group.status;
  beat.s = group.s;
  beat.t = group.t;
  beat.exponent = group.exponent;
  const std::array<Wide, 2> x{group.dudx.raw(), group.dvdx.raw()};
  const std::array<Wide, 2> y{group.dudy.raw(), group.dvdy.raw()};
  const bool x_is_longer = length_of(y[0], y[1]) < length_of(x[0], x[1]);
  const auto& longer = x_is_longer ? x : y;
  const auto& shorter = x_is_longer ? y : x;
  const Wide long_length = length_of(longer[0], longer[1]);
  const Wide short_length = length_of(shorter[0], shorter[1]);
  const auto mode = static_cast<Mode>(state.mode.raw());
  if (mode != Mode::kTable) {
    Wide minor = long_length;
    if (mode == Mode::kExt || mode == Mode::kSimple) minor = short_length;
    if (mode == Mode::kSimple) {
      minor = std::min(minor, length_of(x[0] + y[0], x[1] + y[1]));
      minor = std::min(minor, length_of(x[0] - y[0], x[1] - y[1]));
    }
    set(beat.major_u, longer[0] * 256);
    set(beat.major_v, longer[1] * 256);
    set(beat.major_radius, long_length);
    set(beat.minor_radius, minor);
    return beat;
  }
  // The shorter vector as seen from the longer one: which side, and tangent or cotangent of the angle.
  const Wide side = longer[0] * shorter[1] - longer[1] * shorter[0];
  const Wide along = longer[0] * shorter[0] + longer[1] * shorter[1];
  const Wide sine = side < 0 ? -side : side;
  const Wide cosine = along < 0 ? -along : along;
  const std::size_t row = step_of(short_length, long_length, 16);
  const std::size_t column = sine < cosine ? step_of(sine, cosine, 8) : 8 + step_of(cosine, sine, 8);
  const auto& entry = tables().ellipse[row][column];
  // The axis leans from the longer vector towards the shorter one, or its negation, whichever is within 90 degrees.
  const int lean = (side > 0) == (along > 0) ? 1 : -1;
  const Wide turned = side == 0 || along == 0 ? 0 : lean * Wide{entry[1]};
  set(beat.major_u, longer[0] * entry[0] * 2 - longer[1] * turned);
  set(beat.major_v, longer[1] * entry[0] * 2 + longer[0] * turned);
  set(beat.minor_radius, nearest_up({long_length * entry[2], 256}));
  set(beat.major_radius, nearest_up({long_length * entry[3], 128}));
  return beat;
}

}  // namespace feline::oracle
