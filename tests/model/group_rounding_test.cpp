// SPDX-License-Identifier: Apache-2.0
// Why group rounds to nearest for Feline and outward otherwise: truncation, nearest and outward compared over random
// ellipses, in double precision and written apart from model/group.h. Nearest is the most accurate; only outward never
// lets a growing footprint shrink, which the isotropic modes promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tests/support/random.h"

namespace feline {
namespace {

enum class Rounding { kTruncation, kNearest, kOutward };
using Gradients = std::array<double, 4>;  // du/dx, dv/dx, du/dy, dv/dy

double rounded(double size, Rounding rounding) {
  if (rounding == Rounding::kTruncation) return std::floor(size);
  return rounding == Rounding::kNearest ? std::floor(size + 0.5) : std::ceil(size);
}

// Four integers of magnitude at most 127 under one exponent, the largest at least 64, as values again.
Gradients grouped(const Gradients& exact, Rounding rounding) {
  double largest = 0;
  for (const double value : exact) largest = std::max(largest, std::abs(value));
  for (int exponent = std::ilogb(largest) - 6;; ++exponent) {
    Gradients result{};
    bool fits = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const double size = rounded(std::ldexp(std::abs(exact[i]), -exponent), rounding);
      fits = fits && size <= 127;
      result[i] = std::copysign(std::ldexp(size, exponent), exact[i]);
    }
    if (fits) return result;
  }
}

struct Radii {
  double major, minor;
};

Radii radii(const Gradients& g) {
  const double sum = std::hypot(g[0] + g[3], g[1] - g[2]) / 2;
  const double difference = std::hypot(g[0] - g[3], g[1] + g[2]) / 2;
  return {sum + difference, std::abs(sum - difference)};
}

// With at most 16 probes.
double level(const Radii& r) { return std::log2(std::max(r.minor, 2 * r.major / 17)); }

double linear_length(double u, double v) {
  const double a = std::max(std::abs(u), std::abs(v));
  const double b = std::min(std::abs(u), std::abs(v));
  return std::max(a + 5 * b / 32, 109 * a / 128 + 35 * b / 64);
}

double isotropic_radius(const Gradients& g) { return std::max(linear_length(g[0], g[1]), linear_length(g[2], g[3])); }

struct Measured {
  double mean_level = 0, worst_level = 0, bias_level = 0, mean_major = 0;
  int falls = 0;
};

Measured measure(Rounding rounding) {
  constexpr int kSamples = 500000;
  constexpr double kTurn = 6.283185307179586;
  Measured measured;
  Random random(7);
  for (int i = 0; i < kSamples; ++i) {
    const double axis = random.real(0, kTurn);
    const double screen = random.real(0, kTurn);
    const double major = std::exp2(random.real(0, 1));
    const double minor = major * std::exp2(random.real(-5, 0));
    const double c = std::cos(axis), s = std::sin(axis), p = std::cos(screen), q = std::sin(screen);
    const Gradients exact{major * c * p - minor * s * q, major * s * p + minor * c * q, -major * c * q - minor * s * p,
                          -major * s * q + minor * c * p};
    const Radii got = radii(grouped(exact, rounding));
    const double error = level(got) - level({major, minor});
    measured.mean_level += std::abs(error) / kSamples;
    measured.bias_level += error / kSamples;
    measured.worst_level = std::max(measured.worst_level, std::abs(error));
    measured.mean_major += std::abs(got.major / major - 1) / kSamples;
    // Growth across the change of exponent: the largest part goes from just below 127 to just above.
    Gradients before = exact;
    const double largest = std::max({std::abs(exact[0]), std::abs(exact[1]), std::abs(exact[2]), std::abs(exact[3])});
    for (auto& value : before) value *= random.real(126.5, 128) / largest;
    Gradients after = before;
    const double growth = 1 + random.real(0, 0.01);
    for (auto& value : after) value *= growth;
    const double fall = isotropic_radius(grouped(before, rounding)) - isotropic_radius(grouped(after, rounding));
    measured.falls += fall > 0 ? 1 : 0;
  }
  return measured;
}

TEST(group, outward_rounding_is_the_only_monotonic_one) {
  constexpr const char* kNames[] = {"truncation", "nearest", "outward"};
  std::array<Measured, 3> all;
  std::printf("%-12s%22s%10s%10s%14s%10s\n", "rounding", "level, octaves: mean", "bias", "worst", "major, mean",
              "falls");
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = measure(static_cast<Rounding>(i));
    std::printf("%-12s%22.4f%+10.4f%10.3f%13.3f%%%10d\n", kNames[i], all[i].mean_level, all[i].bias_level,
                all[i].worst_level, 100 * all[i].mean_major, all[i].falls);
  }
  EXPECT_LT(all[1].mean_level, 0.6 * all[2].mean_level);
  EXPECT_NEAR(all[0].mean_level, all[2].mean_level, 0.001);
  EXPECT_GT(all[2].bias_level, 0) << "outward blurs a little, it never aliases";
  EXPECT_GT(all[0].falls, 0);
  EXPECT_GT(all[1].falls, 0);
  EXPECT_EQ(all[2].falls, 0);
}

TEST(group, truncation_and_nearest_shrink_a_growing_footprint) {
  const auto falls = [](Gradients before, double growth, Rounding rounding) {
    Gradients after = before;
    for (auto& value : after) value *= growth;
    return isotropic_radius(grouped(after, rounding)) < isotropic_radius(grouped(before, rounding));
  };
  EXPECT_TRUE(falls({127.664, 0.925, 67.409, 109.039}, 1.00572, Rounding::kTruncation));
  EXPECT_TRUE(falls({127.301, 4.203, 92.547, 92.502}, 1.00360, Rounding::kNearest));
  EXPECT_FALSE(falls({127.664, 0.925, 67.409, 109.039}, 1.00572, Rounding::kOutward));
  EXPECT_FALSE(falls({127.301, 4.203, 92.547, 92.502}, 1.00360, Rounding::kOutward));
}

}  // namespace
}  // namespace feline
