// SPDX-License-Identifier: Apache-2.0
#include "tables/interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "testbench/stability/real.h"
#include "tests/support/random.h"

namespace feline {
namespace {

// The enclosure holds the real value, to within `width`: seen through what it certifies. At 30 fraction bits a rounding
// is uncertain only beside a boundary; what it says elsewhere must be the real's.
void expect_encloses(const Interval& interval, const Real& real, double width) {
  EXPECT_NEAR(interval.middle(), real.to_double(), width);
  for (const int bits : {8, 16, 24}) {
    try {
      EXPECT_EQ(interval.certified_floor(bits), real.floored(bits)) << real.to_double();
    } catch (const std::domain_error&) {
      const double scaled = std::ldexp(real.to_double(), bits);
      EXPECT_NEAR(scaled, std::round(scaled), std::ldexp(width, bits) + 1e-6) << real.to_double();
    }
    try {
      EXPECT_EQ(interval.certified_round(bits), (real + std::ldexp(1.0, -bits - 1)).floored(bits)) << real.to_double();
    } catch (const std::domain_error&) {
      const double scaled = std::ldexp(real.to_double(), bits) + 0.5;
      EXPECT_NEAR(scaled, std::round(scaled), std::ldexp(width, bits) + 1e-6) << real.to_double();
    }
  }
}

TEST(interval, arithmetic_encloses) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("tables_interval.arithmetic_encloses");
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t p = random.between(-3000, 3000);
    const std::int64_t q = random.between(1000, 3000);
    const std::int64_t r = random.between(1, 3000);
    const Interval a = Interval::ratio(p, q);
    const Interval b = Interval::ratio(r, q);
    const Real x = Real::ratio(p, q);
    const Real y = Real::ratio(r, q);
    expect_encloses(a, x, 1e-15);
    expect_encloses(a + b, x + y, 1e-15);
    expect_encloses(a - b, x - y, 1e-15);
    expect_encloses(a * b, x * y, 1e-15);
    if (r * 100 > q) expect_encloses(a / b, x / y, 1e-11);
    expect_encloses(square_root(b), sqrt(y), 1e-14);
  }
}

TEST(interval, functions_enclose) {
  for (int i = 0; i <= 1000; ++i) {
    expect_encloses(exponential(Interval::ratio(4 * i - 2000, 1000)), exp(Real::ratio(4 * i - 2000, 1000)), 1e-12);
    if (i < 1000) expect_encloses(logarithm2(Interval::ratio(1000 + i, 1000)), log2(Real::ratio(1000 + i, 1000)), 2e-9);
    expect_encloses(fifth_root(Interval::ratio(i, 1000)), pow(Real::ratio(i, 1000), Real::ratio(1, 5)), 1e-9);
  }
}

TEST(interval, uncertain_rounding_throws) {
  const Interval third = Interval::ratio(1, 3);
  EXPECT_THROW((third * Interval::integer(3)).certified_floor(8), std::domain_error);
  EXPECT_THROW((third * Interval::integer(3) * Interval::ratio(1, 512)).certified_round(8), std::domain_error);
  EXPECT_EQ(Interval::ratio(1, 512).certified_round(8), 1);  // an exact tie goes up
  EXPECT_EQ(Interval::ratio(-1, 512).certified_round(8), 0);
  EXPECT_THROW(third / Interval{}, std::domain_error);
}

}  // namespace
}  // namespace feline
