// SPDX-License-Identifier: Apache-2.0
// The bounds that invariant 5's proof rests on, by enumeration.
#include <gtest/gtest.h>

#include "tests/support/monotonic.h"

namespace feline {
namespace {

// Quadruples up to symmetry, dudx the largest: x and y, u and v swap, u and v reflect, vectors negate.
template <typename Visit>
void for_each_quad(std::int64_t step, Visit visit) {
  for (std::int64_t a = 64; a <= 127; ++a) {
    for (std::int64_t b = 0; b <= a; b += step) {
      for (std::int64_t c = 0; c <= a; c += step) {
        for (std::int64_t d = -a; d <= a; d += step) visit(Quad{a, b, c, d});
      }
    }
  }
}

RatioBounds bounds_of(Mode mode, std::int64_t step) {
  const State state = state_of(mode);
  RatioBounds bounds;
  for_each_quad(step, [&](const Quad& quad) {
    const auto held = footprint<kDefaultConfig>(group_beat(quad, 0), state);
    bounds.include(ratio_bounds(held, mode == Mode::kSimple ? simple_range(quad) : table_range(quad)));
  });
  return bounds;
}

void expect_within(const RatioBounds& found, const RatioBounds& stated) {
  EXPECT_GE(found.major_low, stated.major_low);
  EXPECT_LE(found.major_high, stated.major_high);
  EXPECT_GE(found.effective_low, stated.effective_low);
  EXPECT_LE(found.effective_high, stated.effective_high);
}

void print(const char* mode, const RatioBounds& found) {
  std::printf("%s: major %.6f .. %.6f, effective %.6f .. %.6f\n", mode, found.major_low, found.major_high,
              found.effective_low, found.effective_high);
}

// Every fifth value of three components: a million quadruples.
TEST(footprint_bounds, hold_on_a_lattice) {
  expect_within(bounds_of(Mode::kSimple, 5), kSimpleRatios);
  expect_within(bounds_of(Mode::kTable, 5), kTableRatios);
}

// All 126,000,000 quadruples up to symmetry: these are the bounds, to six digits.
TEST(footprint_bounds_long, are_those_of_all_quadruples) {
  for (const Mode mode : {Mode::kSimple, Mode::kTable}) {
    const RatioBounds found = bounds_of(mode, 1);
    const RatioBounds& stated = mode == Mode::kSimple ? kSimpleRatios : kTableRatios;
    print(mode_name(mode).c_str(), found);
    expect_within(found, stated);
    EXPECT_NEAR(found.low(), stated.low(), 1e-5);
    EXPECT_NEAR(found.high(), stated.high(), 1e-5);
  }
}

}  // namespace
}  // namespace feline
