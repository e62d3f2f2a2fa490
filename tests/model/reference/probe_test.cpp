// SPDX-License-Identifier: Apache-2.0
#include "model/reference/probe.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/random.h"
#include "tests/support/reference_images.h"
#include "tests/support/reference_sampling.h"

namespace feline::reference {
namespace {

constexpr std::array kWraps{Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClampToEdge, Wrap::kClampToBorder};
constexpr Texel kBorder{0.25F, 0.5F, 0.75F, 1};

// A cubic of the family with B + 2C = 1 is B of the cubic B-spline, the convolution of four boxes, and 1 - B of
// Catmull-Rom's spline, the Hermite cubic with slopes by central differences.
double b_spline(double x) {
  double sum = 0;
  constexpr std::array<double, 5> kBinomial{1, -4, 6, -4, 1};
  for (int j = 0; j < 5; ++j) sum += kBinomial[static_cast<std::size_t>(j)] * std::pow(std::max(0.0, x + 2 - j), 3) / 6;
  return sum;
}
double catmull_rom(double x) {
  const double d = std::abs(x);
  if (d >= 2) return 0;
  const double f = d < 1 ? d : d - 1;
  const double value = (1 + 2 * f) * (1 - f) * (1 - f);  // Hermite: value and slope at 0, slope at 1
  const double slope0 = f * (1 - f) * (1 - f);
  const double slope1 = f * f * (f - 1);
  return d < 1 ? value - slope1 / 2 : -slope0 / 2;
}

TEST(reference_probe, wrapped_texels_as_opengl_says) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_probe.wrapped_texels_as_opengl_says");
  for (const auto& [width, height] : {std::pair{8, 4}, {1, 16}, {1, 1}, {5, 3}}) {
    const Level level = noise_level(width, height, random);
    for (const Wrap s : kWraps)
      for (const Wrap t : kWraps)
        for (int i = 0; i < 500; ++i) {
          const auto reach = random.one_in(4) ? std::int64_t{1} << 40 : std::int64_t{40};
          const auto x = random.between(-reach, reach);
          const auto y = random.between(-reach, reach);
          EXPECT_EQ(wrapped_texel(level, {s, t, kBorder}, x, y), gl_texel(level, {s, t, kBorder}, x, y));
        }
  }
  EXPECT_EQ(wrap_index(-1, 8, Wrap::kClampToBorder), -1);
  EXPECT_EQ(wrap_index(8, 8, Wrap::kClampToBorder), -1);
  EXPECT_EQ(wrap_index(-1, 8, Wrap::kMirroredRepeat), 0);
  EXPECT_EQ(wrap_index(8, 8, Wrap::kMirroredRepeat), 7);
}

// Every kernel against its definition over all texels, on odd sizes and all wraps, beyond the edges, too.
TEST(reference_probe, kernels_by_their_definitions) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_probe.kernels_by_their_definitions");
  const std::array levels{noise_level(12, 7, random), noise_level(1, 2, random)};
  for (int i = 0; i < 20000; ++i) {
    const Level& level = random.pick(levels);
    const Wrapping wrapping{random.pick(kWraps), random.pick(kWraps), kBorder};
    const double s = random.real(-4, 5);
    const double t = random.real(-4, 5);
    const auto expect = [&](const Colour& got, double reach, const auto& kernel) {
      const auto want = sum_texels(level, wrapping, s * level.width, t * level.height, reach,
                                   [&](double du, double dv) { return kernel(du) * kernel(dv); });
      EXPECT_LE(distance(got, want.mean()), 1e-13) << s << " " << t;
    };
    EXPECT_EQ(nearest(level, wrapping, s, t)[0], gl_texel(level, wrapping, std::llround(std::floor(s * level.width)),
                                                          std::llround(std::floor(t * level.height)))[0]);
    expect(two_by_two(level, wrapping, ProbeKernel::kBilinear, s, t), 1, tent);
    // Erratum 11: exp(-2 d^2), d = 1 at sqrt(2) texels, cut off at the 2 x 2 texels.
    expect(two_by_two(level, wrapping, ProbeKernel::kGaussian, s, t), 1,
           [](double d) { return std::abs(d) < 1 ? std::exp(-2 * std::pow(d / std::numbers::sqrt2, 2)) : 0; });
    expect(bicubic(level, wrapping, kCatmullRom, s, t), 2, catmull_rom);
    expect(bicubic(level, wrapping, kMitchell, s, t), 2,
           [](double d) { return b_spline(d) / 3 + 2 * catmull_rom(d) / 3; });
  }
}

TEST(reference_probe, cubic_values) {
  EXPECT_NEAR(cubic_weight(kMitchell, 0), 16.0 / 18, 1e-15);
  EXPECT_NEAR(cubic_weight(kMitchell, 1), 1.0 / 18, 1e-15);
  EXPECT_NEAR(cubic_weight(kMitchell, -1), 1.0 / 18, 1e-15);
  EXPECT_NEAR(cubic_weight(kMitchell, 2), 0, 1e-15);
  EXPECT_NEAR(cubic_weight(kCatmullRom, 0), 1, 1e-15);
  EXPECT_NEAR(cubic_weight(kCatmullRom, 1), 0, 1e-15);
  EXPECT_NEAR(cubic_weight(kCatmullRom, 0.5), 9.0 / 16, 1e-15);
  EXPECT_NEAR(cubic_weight(kCatmullRom, 1.5), -1.0 / 16, 1e-15);
  EXPECT_EQ(cubic_weight(kMitchell, 3), 0);
  for (const Cubic& cubic : {kCatmullRom, kMitchell, Cubic{1, 0}, Cubic{0.3, 0.6}}) {
    for (double f = 0; f < 1; f += 1.0 / 64) {
      double sum = 0;
      double moment = 0;
      for (int i = -1; i <= 2; ++i) {
        sum += cubic_weight(cubic, i - f);
        moment += (i - f) * cubic_weight(cubic, i - f);
      }
      EXPECT_NEAR(sum, 1, 1e-14) << f;
      if (std::abs(cubic.b + 2 * cubic.c - 1) < 1e-15) {
        EXPECT_NEAR(moment, 0, 1e-14) << f;
      }
    }
  }
}

// Catmull-Rom goes through the texels and through any parabola.
TEST(reference_probe, catmull_rom_interpolates) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_probe.catmull_rom_interpolates");
  const Level noise = noise_level(16, 16, random);
  const Level parabola = level_of(16, 16, [](double s, double t) {
    return grey(s * s - 2 * s * t + 3 * t * t - 0.5 * s + 0.25);  // of 10 bits: exact in float
  });
  for (int i = 0; i < 2000; ++i) {
    const int x = static_cast<int>(random.below(16));
    const int y = static_cast<int>(random.below(16));
    const auto got = bicubic(noise, kRepeated, kCatmullRom, (x + 0.5) / 16, (y + 0.5) / 16);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(got[c], static_cast<double>(noise.at(x, y)[c]), 1e-15);
    const double s = random.real(0.15, 0.85);
    const double t = random.real(0.15, 0.85);
    EXPECT_NEAR(bicubic(parabola, kClamped, kCatmullRom, s, t)[0], s * s - 2 * s * t + 3 * t * t - 0.5 * s + 0.25,
                1e-14);
  }
}

// A wave of w radians a texel at fraction f of the way between two texels, phase p at the first: the real part of
// e^(ip) (1 - f + f e^(iw)), for the Gaussian with f replaced by 1/(1 + e^(1 - 2f)).
TEST(reference_probe, attenuation_of_waves) {
  constexpr int kSize = 64;
  for (const int periods : {1, 5, 16, 31, 32}) {
    const double w = 2 * std::numbers::pi * periods / kSize;
    const Level wave =
        level_of(kSize, 1, [&](double s, double) { return grey(std::cos(2 * std::numbers::pi * periods * s)); });
    for (double f = 0; f < 1; f += 1.0 / 16) {
      const double p = w * 10.5;
      const double s = (10.5 + f) / kSize;
      const auto between = [&](double weight) { return (1 - weight) * std::cos(p) + weight * std::cos(p + w); };
      EXPECT_NEAR(two_by_two(wave, kRepeated, ProbeKernel::kBilinear, s, 0.5)[1], between(f), 1e-7);
      EXPECT_NEAR(two_by_two(wave, kRepeated, ProbeKernel::kGaussian, s, 0.5)[1],
                  between(1 / (1 + std::exp(1 - 2 * f))), 1e-7);
    }
  }
}

// The level of detail is clamped to the levels there are, and two levels are blended by its fraction; a level that
// weighs nothing is not read. A probe is one cycle of eight texels.
TEST(reference_probe, mip_probe_blends_levels) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_probe.mip_probe_blends_levels");
  const MipMap noise = box_map(noise_level(32, 8, random), {Wrap::kMirroredRepeat, Wrap::kRepeat, {}});
  const MipMap levels = level_map(32, 8);
  ASSERT_EQ(levels.levels.size(), 6U);
  EXPECT_EQ(levels.smallest_level(), 5);
  for (const ProbeKernel kernel : {ProbeKernel::kBilinear, ProbeKernel::kGaussian}) {
    for (int i = 0; i < 2000; ++i) {
      const double lod = i % 4 == 0 ? static_cast<double>(random.between(-2, 8)) : random.real(-2, 8);
      const double s = random.real(-1, 2);
      const double t = random.real(-1, 2);
      Cost cost;
      EXPECT_NEAR(mip_probe(levels, kernel, lod, s, t, cost)[0], std::clamp(lod, 0.0, 5.0), 1e-14);
      EXPECT_EQ(cost.probes, 1);
      EXPECT_EQ(cost.cycles, 1);
      EXPECT_EQ(cost.stamp_cycles, 1);
      EXPECT_EQ(cost.texels, lod <= 0 || lod >= 5 || lod == std::floor(lod) ? 4 : 8);
      if (kernel == ProbeKernel::kBilinear) {
        EXPECT_LE(distance(mip_probe(noise, kernel, lod, s, t, cost), trilinear_sample(noise, lod, s, t)), 1e-14);
      }
    }
  }
  Cost cost;
  EXPECT_EQ(mip_probe(levels, ProbeKernel::kBilinear, -INFINITY, 0.5, 0.5, cost)[0], 0);
}

}  // namespace
}  // namespace feline::reference
