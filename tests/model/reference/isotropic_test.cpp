// SPDX-License-Identifier: Apache-2.0
#include "model/reference/isotropic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/random.h"
#include "tests/support/reference_images.h"
#include "tests/support/reference_sampling.h"

namespace feline::reference {
namespace {

// CS248A lecture 4, "Computing mipmap level": log2 of the longer of both gradients in texels, of a texture that is not
// square.
TEST(reference_isotropic, level_of_detail) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_isotropic.level_of_detail");
  const MipMap map = level_map(256, 64);
  for (int i = 0; i < 10000; ++i) {
    const auto g = random_gradients(random, log_uniform(random, -2, 3), log_uniform(random, -2, 3));
    const double longest = std::sqrt(std::max(g.x.u * g.x.u + g.x.v * g.x.v, g.y.u * g.y.u + g.y.v * g.y.v));
    const Lookup lookup = lookup_at(map.base(), random.real(-300, 300), random.real(-300, 300), g);
    EXPECT_NEAR(isotropic_level(map, lookup), std::log2(longest), 1e-13);
    // The level that is read shows in the colour.
    const double level = std::clamp(std::log2(longest), 0.0, 8.0);
    Cost cost;
    EXPECT_NEAR(trilinear_filter(map, lookup, cost)[0], level, 1e-13);
    const double near = std::ceil(level - 0.5);
    if (std::abs(level - std::floor(level) - 0.5) > 1e-9) {
      EXPECT_EQ(nearest_mip_filter(map, lookup, cost)[0], near);
      EXPECT_NEAR(bilinear_mip_filter(map, lookup, cost)[0], near, 1e-14);
    }
    EXPECT_EQ(nearest_filter(map, lookup, cost)[0], 0);
    EXPECT_EQ(bilinear_filter(map, lookup, cost)[0], 0);
    EXPECT_EQ(bicubic_filter(map, kMitchell, lookup, cost)[0], 0);
  }
}

TEST(reference_isotropic, levels_at_the_edges) {
  const MipMap map = level_map(256, 64);
  const auto detail = [&](double length) {
    Cost cost;
    return trilinear_filter(map, lookup_at(map.base(), 9, 9, {{length, 0}, {0, length / 2}}), cost)[0];
  };
  EXPECT_EQ(detail(1), 0);
  EXPECT_EQ(detail(0.25), 0);
  EXPECT_EQ(detail(0), 0);
  EXPECT_EQ(detail(2), 1);
  EXPECT_EQ(detail(256), 8);
  EXPECT_EQ(detail(1e300), 8);
  const Lookup none = lookup_at(map.base(), 9, 9, {});
  EXPECT_EQ(isotropic_level(map, none), -INFINITY);
  // The levels part half way, at the square root of 2.
  Cost cost;
  EXPECT_EQ(nearest_mip_filter(map, lookup_at(map.base(), 9, 9, {{1.4143, 0}, {0, 0}}), cost)[0], 1);
  EXPECT_EQ(nearest_mip_filter(map, lookup_at(map.base(), 9, 9, {{1.4142, 0}, {0, 0}}), cost)[0], 0);
}

// Each filter is its own sentence of the lecture, on noise.
TEST(reference_isotropic, samples_of_noise) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_isotropic.samples_of_noise");
  const MipMap map = box_map(noise_level(64, 32, random), kRepeated);
  for (int i = 0; i < 5000; ++i) {
    const auto g = random_gradients(random, log_uniform(random, -1, 2), 1);
    const double u = random.real(-100, 100);
    const double v = random.real(-100, 100);
    const Lookup lookup = lookup_at(map.base(), u, v, g);
    const double level = std::log2(std::max(std::hypot(g.x.u, g.x.v), std::hypot(g.y.u, g.y.v)));
    const auto near = static_cast<std::size_t>(std::clamp(std::ceil(level - 0.5), 0.0, 6.0));
    const auto [s, t] = lookup.position;
    Cost cost;
    EXPECT_LE(distance(bilinear_filter(map, lookup, cost), tent_sample(map.base(), kRepeated, s, t)), 1e-12);
    EXPECT_LE(distance(trilinear_filter(map, lookup, cost), trilinear_sample(map, level, s, t)), 1e-12);
    EXPECT_LE(distance(bilinear_mip_filter(map, lookup, cost), tent_sample(map.levels[near], kRepeated, s, t)), 1e-12);
    const auto holds = gl_texel(map.base(), kRepeated, std::llround(std::floor(u)), std::llround(std::floor(v)));
    EXPECT_EQ(nearest_filter(map, lookup, cost)[2], static_cast<double>(holds[2]));
    EXPECT_EQ(bicubic_filter(map, kCatmullRom, lookup, cost), bicubic(map.base(), kRepeated, kCatmullRom, s, t));
  }
}

// Level k holds the wave times its own share 2^-k: trilinear blends both levels' shares, each at its own texels.
TEST(reference_isotropic, trilinear_of_a_wave) {
  constexpr int kPeriods = 3;
  const auto phase = [](double s) { return 2 * std::numbers::pi * kPeriods * s; };
  const MipMap map =
      map_of(256, 256, kRepeated, [&](double s, double, int k) { return grey(std::ldexp(std::cos(phase(s)), -k)); });
  for (const double length : {1.0, 1.3, 2.9, 4.0, 7.0, 13.5}) {
    const double level = std::log2(length);
    const int fine = static_cast<int>(level);
    for (int x = 0; x < 256; ++x) {
      // Read at the fine level's texels; the coarse level's are a quarter of its texel beside, so that its cosine is
      // (3 cos a + cos b) / 4, a and b a quarter and three quarters away.
      const double step = std::ldexp(1.0 / 256, fine);
      const double s = (x + 0.5) * step;
      const double away = x % 2 == 0 ? step / 2 : -step / 2;
      const double coarse = 0.75 * std::cos(phase(s + away)) + 0.25 * std::cos(phase(s - 3 * away));
      const double want =
          std::ldexp(std::cos(phase(s)), -fine) * (fine + 1 - level) + std::ldexp(coarse, -fine - 1) * (level - fine);
      Cost cost;
      const Lookup lookup{{s, 0.5}, {{length / 256, 0}, {0, 0.7 * length / 256}}};
      EXPECT_NEAR(trilinear_filter(map, lookup, cost)[0], want, 1e-7) << length << " " << x;
    }
  }
}

TEST(reference_isotropic, costs) {
  const MipMap map = level_map(256, 64);
  const Lookup lookup = lookup_at(map.base(), 9, 9, {{3, 0}, {0, 1}});
  const auto texels = [&](const auto& filter) {
    Cost cost;
    filter(cost);
    EXPECT_EQ(cost.probes, 1);
    return cost.texels;
  };
  EXPECT_EQ(texels([&](Cost& cost) { nearest_filter(map, lookup, cost); }), 1);
  EXPECT_EQ(texels([&](Cost& cost) { nearest_mip_filter(map, lookup, cost); }), 1);
  EXPECT_EQ(texels([&](Cost& cost) { bilinear_filter(map, lookup, cost); }), 4);
  EXPECT_EQ(texels([&](Cost& cost) { bilinear_mip_filter(map, lookup, cost); }), 4);
  EXPECT_EQ(texels([&](Cost& cost) { bicubic_filter(map, kMitchell, lookup, cost); }), 16);
  EXPECT_EQ(texels([&](Cost& cost) { trilinear_filter(map, lookup, cost); }), 8);
}

}  // namespace
}  // namespace feline::reference
