// SPDX-License-Identifier: Apache-2.0
#include "model/reference/feline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "model/reference/approximate_axes.h"
#include "testbench/stability/real.h"
#include "tests/support/random.h"
#include "tests/support/reference_ewa.h"
#include "tests/support/reference_lines.h"

namespace feline::reference {
namespace {

Axes<double> axes_of(double major, double minor, double angle = 0) {
  return {{major * std::cos(angle), major * std::sin(angle)}, major, minor};
}

// (13, 0), (12, 5): radii sqrt(325) and sqrt(13), nine probes a minor radius apart along (5, 1), of weight
// exp(-2 (n/2)^2 13/325).
TEST(reference_feline, the_papers_example) {
  const ProbeLine line = plan_feline(ellipse_axes<double>({{13, 0}, {12, 5}}), kExact, 20);
  EXPECT_EQ(line.probes, 9);
  EXPECT_NEAR(line.level_of_detail, std::log2(13.0) / 2, 1e-14);
  EXPECT_NEAR(line.step.u, 5 / std::sqrt(2.0), 1e-13);  // sqrt(13) (5, 1) / sqrt(26)
  EXPECT_NEAR(line.step.v, 1 / std::sqrt(2.0), 1e-13);
  EXPECT_NEAR(line.falloff, 0.08, 1e-15);
  // Simple: 13 and 5.156, 2 * 2.5212 - 1 = 4.04 probes, rounded down; Feline widens to 2 * 13/5.
  const ProbeLine simple = plan_feline(simple_axes({{13, 0}, {12, 5}}), kExact, 20);
  EXPECT_EQ(simple.probes, 4);
  EXPECT_NEAR(simple.level_of_detail, std::log2(26.0 / 5), 1e-14);
  EXPECT_NEAR(simple.step.u, 2 * (13 - 26.0 / 5) / 3, 1e-13);
}

// 3.1's code and 3.4's, in 200 bits, from radii.
struct Want {
  int probes;
  Real minor, step, falloff;
};
Want want_line(double major_radius, double minor_radius, const FelineParameters& p) {
  const auto larger = [](const Real& a, const Real& b) { return a < b ? b : a; };
  Real minor = larger(Real(minor_radius), Real(1));
  Real major = larger(larger(Real(major_radius), Real(1)) * p.length_factor, minor);
  const auto most = static_cast<double>(p.max_probes);
  double probes = 0;
  if (p.ceiling) {
    const double f = (Real(2) * major / (minor * p.blur_factor * p.alias_factor)).to_double();
    probes = std::clamp(std::ceil(f) - 1, 1.0, most);  // wide factors ask for none, of which 3.4 says nothing
    const bool clamped = std::ceil(f) - 1 > most;
    const Real widest = Real(2) * major / Real(probes + 1);
    if (clamped) {
      minor = widest / p.alias_factor;
    } else {
      minor = widest < minor * p.blur_factor ? widest : minor * p.blur_factor;
    }
  } else {
    const Real f = Real(2) * major / minor - Real(1);
    probes = std::min(std::floor(f.to_double() + 0.5), most);
    if (Real(probes) < f) minor = Real(2) * major / Real(probes + 1);
  }
  const Real step = probes == 1 ? Real() : Real(2) * (major - minor) / Real(probes - 1);
  return {static_cast<int>(probes), minor, step, Real(2) * step * step / (major * major)};
}

TEST(reference_feline, plans_in_200_bits) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_feline.plans_in_200_bits");
  for (int i = 0; i < 30000; ++i) {
    const FelineParameters any{random.one_in(2), random.real(0.8, 1), random.real(1, 2), random.real(1, 1.5),
                               static_cast<int>(random.between(1, 32))};
    const FelineParameters parameters =
        random.pick(std::array{kExact, kHighQuality, kHighEfficiency, any, FelineParameters{true}});
    FelineParameters p = parameters;
    if (!p.ceiling) p.length_factor = p.blur_factor = p.alias_factor = 1;  // 3.1 has none
    const double minor = log_uniform(random, -1, 2);
    const double major = minor * (random.one_in(2) ? random.real(1, 3) : log_uniform(random, 0, 1.7));
    const double angle = random.real(0, 6);
    const Want want = want_line(major, minor, p);
    const ProbeLine line = plan_feline(axes_of(major, minor, angle), p, 30);
    ASSERT_EQ(line.probes, want.probes) << major << " " << minor;
    EXPECT_NEAR(line.level_of_detail, log2(want.minor).to_double(), 1e-13) << major << " " << minor;
    if (want.probes == 1) continue;
    const double step = want.step.to_double();
    EXPECT_NEAR(line.step.u, step * std::cos(angle), 1e-12 * major);
    EXPECT_NEAR(line.step.v, step * std::sin(angle), 1e-12 * major);
    EXPECT_NEAR(line.falloff, want.falloff.to_double(), 1e-12);
  }
}

// 3.4: "if fProbes is 1.499, rounding down to 1 scales minorRadius up by 25%; if fProbes is 4.499, rounding down to 4
// scales minorRadius up by only 10%." Rounding up leaves it.
TEST(reference_feline, rounding_of_the_probe_count) {
  const auto widened = [](double f_probes, int want_probes) {
    const ProbeLine line = plan_feline(axes_of(2 * (f_probes + 1), 4), kExact, 20);
    EXPECT_EQ(line.probes, want_probes) << f_probes;
    return std::exp2(line.level_of_detail) / 4;
  };
  EXPECT_NEAR(widened(1.499, 1), 1.2495, 1e-12);
  EXPECT_NEAR(widened(4.499, 4), 1.0998, 1e-12);
  EXPECT_NEAR(widened(1.5, 2), 1, 1e-14);
  EXPECT_NEAR(widened(4.75, 5), 1, 1e-14);
  EXPECT_NEAR(widened(7, 7), 1, 1e-14);
  EXPECT_NEAR(widened(40, 16), 41.0 / 17, 1e-12);
}

// High efficiency, major 20, minor 4: 0.9625 * 2 * 5/(1.3125 * 1.3544) = 5.415, five probes; 2 * 19.25/6 = 6.417 is
// more than 4 * 1.3125 = 5.25. Major 200: 54.1, clamped to 16, and 2 * 192.5/(17 * 1.3544) = 16.72.
TEST(reference_feline, factors_by_hand) {
  const ProbeLine free = plan_feline(axes_of(20, 4), kHighEfficiency, 20);
  EXPECT_EQ(free.probes, 5);
  EXPECT_NEAR(std::exp2(free.level_of_detail), 5.25, 1e-12);
  EXPECT_NEAR(free.step.u, 2 * (19.25 - 5.25) / 4, 1e-12);
  const ProbeLine clamped = plan_feline(axes_of(200, 4), kHighEfficiency, 20);
  EXPECT_EQ(clamped.probes, 16);
  EXPECT_NEAR(std::exp2(clamped.level_of_detail), 385 / (17 * 1.3544), 1e-12);
  EXPECT_NEAR(clamped.step.u / std::exp2(clamped.level_of_detail), 1.3544 * (1 + 2 / 15.0) - 2 / 15.0, 1e-12);
}

TEST(reference_feline, radii_below_a_texel) {
  const ProbeLine magnified = plan_feline(axes_of(0.25, 0.125), kExact, 20);
  EXPECT_EQ(magnified.probes, 1);
  EXPECT_EQ(magnified.level_of_detail, 0);
  const ProbeLine half = plan_feline(axes_of(3, 0.01), kExact, 20);
  EXPECT_EQ(half.probes, 5);
  EXPECT_EQ(half.level_of_detail, 0);
  EXPECT_NEAR(half.step.u, 1, 1e-14);
  const ProbeLine none = plan_feline({{0, 0}, 0, 0}, kExact, 20);
  EXPECT_EQ(none.probes, 1);
  EXPECT_EQ(none.level_of_detail, 0);
}

// 3.1: beyond the 1 x 1 level a single probe; at it still many.
TEST(reference_feline, beyond_the_smallest_level) {
  EXPECT_EQ(plan_feline(axes_of(1024, 256), kExact, 8).probes, 7);
  const ProbeLine beyond = plan_feline(axes_of(1028, 257), kExact, 8);
  EXPECT_EQ(beyond.probes, 1);
  EXPECT_EQ(beyond.level_of_detail, 8);
}

// The line against 3.1's sum, its weights in 200 bits, each number of probes; an odd one has its middle once.
TEST(reference_feline, weights_and_positions) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_feline.weights_and_positions");
  const MipMap map = box_map(noise_level(64, 64, random), kRepeated);
  for (int probes = 1; probes <= 16; ++probes) {
    const double major = 2.5 * (probes + 1);
    const double angle = random.real(0, 6);
    const Vector2<double> step{5 * std::cos(angle), 5 * std::sin(angle)};
    const auto weight = [&](double d) {
      const Real away = Real(d) * 5 / Real(major);
      return exp(Real(-2) * away * away).to_double();
    };
    const double u = random.real(0, 64);
    const double v = random.real(0, 64);
    const Gradients<double> g{axes_of(major, 5, angle).major, {-5 * std::sin(angle), 5 * std::cos(angle)}};
    Cost cost;
    const Lookup lookup = lookup_at(map.base(), u, v, g);
    const auto got = feline_filter(map, ellipse_axes<double>, kExact, ProbeKernel::kBilinear, lookup, cost);
    EXPECT_LE(distance(got, sum_probes(map, probes, u, v, step, std::log2(5.0), weight)), 1e-12) << probes;
    EXPECT_EQ(cost.probes, probes);
    EXPECT_EQ(cost.cycles, probes);
    EXPECT_EQ(cost.texels, 8 * probes);
  }
}

// exp(-2 d^2) by hand: three probes of radii 2 : 1 are half the major radius apart, exp(-1/2) = 0.6065 : 1; two of
// 1.5 : 1 are 2/3 apart, both of equal weight.
TEST(reference_feline, weights_by_hand) {
  EXPECT_NEAR(std::exp(-plan_feline(axes_of(8, 4), kExact, 20).falloff), 0.60653, 1e-5);
  EXPECT_NEAR(plan_feline(axes_of(6, 4), kExact, 20).falloff, 2 * 4.0 / 9, 1e-12);
}

// Each probe is every texel within the line's own radius, weighted by exp(-2 d^2).
TEST(reference_feline, line_of_circles) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_feline.line_of_circles");
  const MipMap noise = box_map(noise_level(64, 64, random), kRepeated);
  for (int i = 0; i < 50; ++i) {
    const double u = random.real(0, 64);
    const double v = random.real(0, 64);
    const Lookup lookup =
        lookup_at(noise.base(), u, v, random_gradients(random, random.real(4, 14), random.real(1, 2)));
    const ProbeLine line = plan_feline(ellipse_axes(in_texels(lookup.gradients, noise.base())), kExact, 6);
    const double radius = std::exp2(line.level_of_detail);
    Colour sum{};
    double weights = 0;
    for (int n = 1 - line.probes; n < line.probes; n += 2) {
      const double weight = std::exp(-line.falloff * n * n / 4);
      add_weighted(sum, weight,
                   brute_ewa(noise.base(), kRepeated, u + n * line.step.u / 2, v + n * line.step.v / 2,
                             {{radius, 0}, {0, radius}}, 0)
                       .mean());
      weights += weight;
    }
    Cost cost;
    const Colour got = feline_circles_filter(noise, kExact, lookup, cost);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(got[c], sum[c] / weights, 1e-9);
    EXPECT_EQ(cost.probes, line.probes);
  }
}

// A wave along the line passes by the weighted sum of cosines; 1/8 of the squared phase a texel is lost by linear
// interpolation.
TEST(reference_feline, line_of_a_wave) {
  const double w = 2 * 3.14159265358979323846 / 256;
  const MipMap map = map_of(256, 256, kRepeated, [&](double s, double, int) { return grey(std::cos(256 * w * s)); });
  for (const double ratio : {1.5, 2.0, 3.5, 5.0, 8.0}) {
    const int probes = static_cast<int>(2 * ratio - 1);
    double sum = 0;
    double total = 0;
    for (int k = 0; k < probes; ++k) {
      const double d = k - (probes - 1) / 2.0;
      sum += std::exp(-2 * d * d / (ratio * ratio)) * std::cos(w * 4 * d);
      total += std::exp(-2 * d * d / (ratio * ratio));
    }
    for (double u = 0; u < 256; u += 5.7) {
      Cost cost;
      const auto lookup = lookup_at(map.base(), u, 9.5, {{4 * ratio, 0}, {0, 4}});
      const double got = feline_filter(map, ellipse_axes<double>, kExact, ProbeKernel::kBilinear, lookup, cost)[0];
      EXPECT_NEAR(got, sum / total * std::cos(w * u), 16 * w * w / 8 + 1e-7) << ratio;
    }
  }
}

}  // namespace
}  // namespace feline::reference
