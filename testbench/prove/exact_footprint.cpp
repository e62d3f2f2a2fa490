// SPDX-License-Identifier: Apache-2.0
// What the leaves of group and footprint must give, stated once more from their contracts: floats as doubles, which
// hold every number here exactly, and quotients only as counts of steps.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "testbench/prove/exact_rounding.h"
#include "testbench/prove/exact_tables.h"
#include "testbench/prove/lane_loop.h"
#include "testbench/prove/leaves.h"

namespace feline::prove {
namespace {

constexpr std::int64_t kSign = 0x80000000;
constexpr std::int64_t kInfinity = 0x7f800000;
constexpr std::int64_t kLeastNormal = 0x00800000;

constexpr std::int64_t without_sign(std::int64_t bits) { return bits & (kSign - 1); }

// |x| of a float32's bits; denormals are 0.
double magnitude_of(std::int64_t bits) {
  const std::int64_t magnitude = without_sign(bits);
  const auto normal = static_cast<std::uint32_t>(magnitude < kLeastNormal ? 0 : magnitude);
  return static_cast<double>(std::bit_cast<float>(normal));
}

double power(std::int64_t exponent) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52); }

// The least integer that is not below x >= 0.
std::int64_t not_below(double x) {
  const auto down = static_cast<std::int64_t>(x);
  return down + (static_cast<double>(down) < x ? 1 : 0);
}

struct Vector {
  int u, v;
};

// In 1/128, of each vector whose sides are at most 256, such as the sum of two. Both parts are larger with the larger
// side as a.
constexpr std::size_t kLengthSides = 257;
constexpr std::size_t kLengthStride = 512;
const std::vector<std::uint16_t>& length_table() {
  static const std::vector<std::uint16_t> table = [] {
    std::vector<std::uint16_t> lengths(kLengthSides * kLengthStride);
    for (std::size_t u = 0; u < kLengthSides; ++u) {
      for (std::size_t v = 0; v < kLengthSides; ++v) {
        lengths[u * kLengthStride + v] = static_cast<std::uint16_t>(
            std::max({128 * u + 20 * v, 20 * u + 128 * v, 109 * u + 70 * v, 70 * u + 109 * v}));
      }
    }
    return lengths;
  }();
  return table;
}

int length_of(Vector vector) {
  const auto u = static_cast<std::size_t>(std::abs(vector.u));
  const auto v = static_cast<std::size_t>(std::abs(vector.v));
  return length_table()[u * kLengthStride + v];
}

// How many whole steps of whole/steps fit into part, at most steps - 1. All are below 2^20, so that a quotient that is
// no integer lies farther from the next one than its float's error.
int step_of(int part, int whole, int steps) {
  return std::min(static_cast<int>(static_cast<float>(steps * part) / static_cast<float>(std::max(whole, 1))),
                  steps - 1);
}

struct Ellipse {
  int along_2 = 0, across = 0, minor = 0, major = 0;
};

const std::array<Ellipse, 256>& ellipses_table() {
  static const std::array<Ellipse, 256> table = [] {
    std::array<Ellipse, 256> ellipses;
    for (std::size_t i = 0; i < 256; ++i) {
      const auto& [along, across, minor, major] = oracle::tables().ellipse[i / 16][i % 16];
      ellipses[i] = {static_cast<int>(2 * along), static_cast<int>(across), static_cast<int>(minor),
                     static_cast<int>(major)};
    }
    return ellipses;
  }();
  return table;
}

Footprint::Outputs table_footprint(Vector longer, Vector shorter, int long_length, int short_length) {
  const int cross = longer.u * shorter.v - longer.v * shorter.u;
  const int dot = longer.u * shorter.u + longer.v * shorter.v;
  const int sine = std::abs(cross);
  const int cosine = std::abs(dot);
  const int row = step_of(short_length, long_length, 16);
  const int column = step_of(std::min(sine, cosine), std::max(sine, cosine), 8) + (sine < cosine ? 0 : 8);
  const Ellipse& ellipse = ellipses_table()[static_cast<std::size_t>(16 * row + column)];
  // Towards the shorter vector or its negation, whichever lies within 90 degrees.
  const int turn = (cross > 0 ? 1 : -1) * (dot > 0 ? 1 : -1) * (sine == 0 || cosine == 0 ? 0 : ellipse.across);
  return {longer.u * ellipse.along_2 - longer.v * turn, longer.v * ellipse.along_2 + longer.u * turn,
          (long_length * ellipse.major + 64) / 128, (long_length * ellipse.minor + 128) / 256};
}

}  // namespace

Position::Outputs Position::exact(const Inputs& inputs) {
  const auto [wrap, bits] = inputs;
  const bool clamps = wrap >= static_cast<std::int64_t>(Wrap::kClampToEdge);
  const bool finite = without_sign(bits) < kInfinity;
  const bool is_number = without_sign(bits) <= kInfinity;
  const double units = magnitude_of(bits) * 0x1p24;
  // From 2^68 on a float is a multiple of 2^45 units.
  const double kept = !is_number ? 0 : clamps ? std::min(units, 0x1p43) : units < 0x1p68 ? units : 0;
  const double turns = static_cast<double>(static_cast<std::int64_t>(kept * 0x1p-45));
  const std::int64_t size = nearest(kept - turns * 0x1p45);
  std::int64_t position = bits >= kSign ? -size : size;
  constexpr std::int64_t kHalfTurn = std::int64_t{1} << 44;
  if (position >= kHalfTurn) position -= 2 * kHalfTurn;
  if (position < -kHalfTurn) position += 2 * kHalfTurn;
  return {position, finite ? 1 : 0, finite && clamps && units >= 0x1p43 ? 1 : 0, 0};
}

Align::Outputs Align::exact(const Inputs& inputs) {
  const auto [mode, width, height, dsdx, dtdx, dsdy, dtdy] = inputs;
  const std::int64_t largest_bits =
      std::max(std::max(without_sign(dsdx), without_sign(dtdx)), std::max(without_sign(dsdy), without_sign(dtdy)));
  if (largest_bits >= kInfinity) return {kDerivativeNotFinite, 63, 127, 0, 0, 127};
  // Texels; 24 + 15 bits.
  const auto wide = static_cast<double>(width);
  const auto high = static_cast<double>(height);
  const double ux = magnitude_of(dsdx) * wide;
  const double vx = magnitude_of(dtdx) * high;
  const double uy = magnitude_of(dsdy) * wide;
  const double vy = magnitude_of(dtdy) * high;
  const double largest = std::max(std::max(ux, vx), std::max(uy, vy));
  if (largest < 0x1p-90) return {0, -64, 0, 0, 0, 0};
  const bool rounds_to_nearest =
      mode == static_cast<std::int64_t>(Mode::kSimple) || mode == static_cast<std::int64_t>(Mode::kTable);
  const auto rounded = [&](double x) { return rounds_to_nearest ? nearest(x) : not_below(x); };
  // In this unit the largest is 64 or more, but less than 128; rounding keeps order, so that it alone decides.
  std::int64_t unit = static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(largest) >> 52) - 1023 - 6;
  if (rounded(largest * power(-unit)) > 127) ++unit;
  if (unit < -64) return {0, -64, 0, 0, 0, 0};
  const double scale = power(-unit);
  const auto mantissa = [&](double magnitude, std::int64_t bits) {
    const std::int64_t size = rounded(magnitude * scale);
    return bits >= kSign ? -size : size;
  };
  return {unit > 63 ? kOverflow : 0, std::min<std::int64_t>(unit, 63),
          mantissa(ux, dsdx),        mantissa(vx, dtdx),
          mantissa(uy, dsdy),        mantissa(vy, dtdy)};
}

Footprint::Outputs Footprint::exact(const Inputs& inputs) {
  const auto [mode, dudx, dvdx, dudy, dvdy] = inputs;
  const Vector x{static_cast<int>(dudx), static_cast<int>(dvdx)};
  const Vector y{static_cast<int>(dudy), static_cast<int>(dvdy)};
  const int x_length = length_of(x);
  const int y_length = length_of(y);
  const int long_length = std::max(x_length, y_length);
  const int short_length = std::min(x_length, y_length);
  const bool x_is_longer = x_length > y_length;
  const Vector longer{x_is_longer ? x.u : y.u, x_is_longer ? x.v : y.v};
  const Vector shorter{x_is_longer ? y.u : x.u, x_is_longer ? y.v : x.v};
  int minor = long_length;
  switch (static_cast<Mode>(mode)) {
    case Mode::kTable: return table_footprint(longer, shorter, long_length, short_length);
    case Mode::kSimple:
      minor = std::min({short_length, length_of({x.u + y.u, x.v + y.v}), length_of({x.u - y.u, x.v - y.v})});
      break;
    case Mode::kExt: minor = short_length; break;
    case Mode::kNearest:
    case Mode::kBilinear:
    case Mode::kTrilinear: break;
  }
  return {256 * longer.u, 256 * longer.v, long_length, minor};
}

template void evaluate_exact<Position>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<Align>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<Footprint>(const std::uint64_t*, std::uint64_t*, std::size_t);

}  // namespace feline::prove
