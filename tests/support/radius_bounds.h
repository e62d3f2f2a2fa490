// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "model/footprint.h"
#include "testbench/stability/ratio_bounds.h"
#include "tests/support/footprints.h"

namespace feline {

// The radii of the derivatives that group rounded to the nearest quadruple, for the bounds of ratio_bounds.h. They lie
// anywhere within half a unit of it in each component; their radii are homogeneous functions: Simple's own with exact
// components, for Table the singular values of the matrix.
struct RadiusRange {
  double major_low, major_high, minor_low, minor_high;
};

struct Span {
  double low, high;  // of a magnitude
};
inline double length_of(double u, double v) {
  const double a = std::max(u, v);
  const double b = std::min(u, v);
  return std::max(a + b * (5.0 / 32), a * (109.0 / 128) + b * (35.0 / 64));
}

// |x + y| for x and y within half a unit of these.
inline Span sum_span(std::int64_t x, std::int64_t y) {
  const double from = static_cast<double>(x + y) - 1;
  const double to = static_cast<double>(x + y) + 1;
  const double nearest = from <= 0 && to >= 0 ? 0 : std::min(std::abs(from), std::abs(to));
  return {nearest, std::max(std::abs(from), std::abs(to))};
}

inline Span span_of(std::int64_t x) {
  const double size = std::abs(static_cast<double>(x));
  return {std::max(size - 0.5, 0.0), size + 0.5};
}

// Unlike the paper's, this length grows with each component, so its extremes are at the ends of the spans.
inline RadiusRange simple_range(const Quad& q) {
  const auto vector = [](Span u, Span v) { return Span{length_of(u.low, v.low), length_of(u.high, v.high)}; };
  const Span x = vector(span_of(q.dudx), span_of(q.dvdx));
  const Span y = vector(span_of(q.dudy), span_of(q.dvdy));
  const Span sum = vector(sum_span(q.dudx, q.dudy), sum_span(q.dvdx, q.dvdy));
  const Span difference = vector(sum_span(q.dudx, -q.dudy), sum_span(q.dvdx, -q.dvdy));
  return {std::max(x.low, y.low), std::max(x.high, y.high), std::min({x.low, y.low, sum.low, difference.low}),
          std::min({x.high, y.high, sum.high, difference.high})};
}

// A singular value moves by at most the norm of the change (Weyl): half the box's diagonal from its centre.
inline RadiusRange table_range(const Quad& q) {
  constexpr double kReach = 1;  // sqrt(4 / 2^2)
  const auto a = static_cast<double>(q.dudx);
  const auto b = static_cast<double>(q.dvdx);
  const auto c = static_cast<double>(q.dudy);
  const auto d = static_cast<double>(q.dvdy);
  // Half the sum and half the difference of the singular values.
  const double sum = std::sqrt((a + d) * (a + d) + (b - c) * (b - c)) / 2;
  const double difference = std::sqrt((a - d) * (a - d) + (b + c) * (b + c)) / 2;
  const double major = sum + difference;
  const double minor = std::abs(sum - difference);
  return {major - kReach, major + kReach, std::max(minor - kReach, 0.0), minor + kReach};
}

inline RatioBounds ratio_bounds(const FootprintBeat<kDefaultConfig>& held, const RadiusRange& real) {
  const double major = held.major_radius.value();
  const double effective = std::max(held.minor_radius.value(), kLeastLine * major);
  return {major / real.major_high, major / real.major_low,
          effective / std::max(real.minor_high, kLeastLine * real.major_high),
          effective / std::max(real.minor_low, kLeastLine * real.major_low)};
}

}  // namespace feline
