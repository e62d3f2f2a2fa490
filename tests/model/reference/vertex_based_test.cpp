// SPDX-License-Identifier: Apache-2.0
#include "model/reference/vertex_based.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/reference/ellipse.h"
#include "tests/support/random.h"
#include "tests/support/reference_images.h"
#include "tests/support/reference_sampling.h"

namespace feline::reference {
namespace {

// Olano, Mukherjee and Dorbie's table 1: a pass multiplies what is there by 1 - alpha and adds alpha of its own.
TEST(reference_vertex_based, table_1) {
  struct Case {
    std::vector<double> weights, alphas;
    std::array<std::array<double, 3>, 3> passes;
  };
  const std::array<Case, 2> cases{{{{1.0 / 3, 1.0 / 3, 1.0 / 3},
                                    {1, 1.0 / 2, 1.0 / 3},
                                    {{{1, 0, 0}, {1.0 / 2, 1.0 / 2, 0}, {1.0 / 3, 1.0 / 3, 1.0 / 3}}}},
                                   {{1.0 / 4, 1.0 / 2, 1.0 / 4},
                                    {1, 2.0 / 3, 1.0 / 4},
                                    {{{1, 0, 0}, {1.0 / 3, 2.0 / 3, 0}, {1.0 / 4, 1.0 / 2, 1.0 / 4}}}}}};
  for (const Case& c : cases) {
    const auto alphas = blend_alphas(c.weights);
    ASSERT_EQ(alphas.size(), 3U);
    std::array<double, 3> share{};
    for (std::size_t pass = 0; pass < 3; ++pass) {
      EXPECT_NEAR(alphas[pass], c.alphas[pass], 1e-15);
      for (std::size_t probe = 0; probe < 3; ++probe) {
        share[probe] = share[probe] * (1 - alphas[pass]) + (probe == pass ? alphas[pass] : 0);
        EXPECT_NEAR(share[probe], c.passes[pass][probe], 1e-15) << pass << probe;
      }
    }
  }
}

std::vector<ProbePattern> patterns() {
  std::vector<ProbePattern> all{square_pattern(2), square_pattern(3), staggered_pattern()};
  for (int probes = 1; probes <= 9; ++probes) all.push_back(line_pattern(probes));
  return all;
}

// Probes lie inside the unit circle in pairs around its middle, are weighted by exp(-2 r^2), and blending them in
// passes leaves each its weight.
TEST(reference_vertex_based, patterns) {
  for (const ProbePattern& pattern : patterns()) {
    ASSERT_EQ(pattern.probes.size(), pattern.weights.size());
    const auto alphas = blend_alphas(pattern.weights);
    double sum = 0;
    double unit = 0;
    for (const auto& probe : pattern.probes) unit += std::exp(-2 * (probe.u * probe.u + probe.v * probe.v));
    for (std::size_t i = 0; i < pattern.probes.size(); ++i) {
      const double u = pattern.probes[i].u;
      const double v = pattern.probes[i].v;
      EXPECT_LT(std::hypot(u, v), 1);
      EXPECT_NEAR(pattern.weights[i], std::exp(-2 * (u * u + v * v)) / unit, 1e-15);
      sum += pattern.weights[i];
      const auto opposite = [&](const Vector2<double>& p) { return std::hypot(p.u + u, p.v + v) < 1e-15; };
      EXPECT_EQ(std::ranges::count_if(pattern.probes, opposite), 1) << u << " " << v;
      double share = alphas[i];
      for (std::size_t later = i + 1; later < alphas.size(); ++later) share *= 1 - alphas[later];
      EXPECT_NEAR(share, pattern.weights[i], 1e-15);
    }
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

TEST(reference_vertex_based, spacing_is_the_distance_to_neighbours) {
  for (const ProbePattern& pattern : patterns()) {
    if (pattern.probes.size() < 2) continue;
    double nearest = 2;
    for (std::size_t i = 0; i < pattern.probes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, length(pattern.probes[i] - pattern.probes[j]));
    EXPECT_NEAR(pattern.spacing, nearest, 1e-15) << pattern.probes.size();
  }
  const auto line = line_pattern(3);
  EXPECT_NEAR(line.spacing, 0.5, 1e-15);  // -1/2, 0, 1/2: set in by a spacing
  EXPECT_NEAR(std::abs(line.probes[0].u), 0.5, 1e-15);
  EXPECT_EQ(line.probes[0].v, 0);
  EXPECT_EQ(line_pattern(1).spacing, 1);  // ordinary mip-mapping
  const auto square = square_pattern(2);
  ASSERT_EQ(square.probes.size(), 4U);
  for (const auto& probe : square.probes) EXPECT_NEAR(std::abs(probe.u), std::abs(probe.v), 1e-15);
  const auto staggered = staggered_pattern();
  ASSERT_EQ(staggered.probes.size(), 8U);
  std::array<int, 3> rows{};
  for (const auto& [u, v] : staggered.probes) ++rows[v < -1e-9 ? 0 : v > 1e-9 ? 2 : 1];
  EXPECT_EQ(rows, (std::array{3, 2, 3}));
}

// Table 2. Ellipse: (A cos, A sin), (-B sin, B cos). Screen: the derivatives. Max: the longer and the shorter
// derivative; its letters take the maximum of each coordinate, which of (a, 0), (0, b) would make (a, b), (0, 0).
TEST(reference_vertex_based, axes_of_table_2) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_vertex_based.axes_of_table_2");
  const Level base{256, 64, {}};
  const auto texels = [&](AxisSystem system, const Gradients<double>& g) {
    return in_texels(vertex_axes(system, lookup_at(base, 0, 0, g).gradients, base), base);
  };
  for (int i = 0; i < 5000; ++i) {
    const double a = log_uniform(random, -1, 2);
    const double b = a * random.unit() * 0.99;
    const double theta = random.real(0, 7);
    const auto g = gradients_of_ellipse(a, b, theta, random.real(0, 7));
    const auto ellipse = texels(AxisSystem::kEllipse, g);
    EXPECT_NEAR(length(ellipse.x), a, 1e-12 * a);
    EXPECT_NEAR(length(ellipse.y), b, 1e-12 * a);
    EXPECT_LE(angle_between_lines(ellipse.x, {std::cos(theta), std::sin(theta)}), 1e-12);
    EXPECT_LE(angle_between_lines(ellipse.y, {-std::sin(theta), std::cos(theta)}), 1e-12);
    EXPECT_GT(ellipse.x.u * ellipse.y.v - ellipse.x.v * ellipse.y.u, 0);  // axis 2 is a quarter turn on
    const auto screen = texels(AxisSystem::kScreen, g);
    EXPECT_NEAR(length(screen.x - g.x) + length(screen.y - g.y), 0, 1e-12 * a);
    const auto most = texels(AxisSystem::kMax, g);
    const bool x_is_longer = length(g.x) > length(g.y);
    EXPECT_LE(angle_between_lines(most.x, x_is_longer ? g.x : g.y), 1e-12);
    EXPECT_NEAR(length(most.x), std::max(length(g.x), length(g.y)), 1e-12 * a);
    EXPECT_NEAR(length(most.y), std::min(length(g.x), length(g.y)), 1e-12 * a);
  }
}

// MIPbias = log2(probe spacing / MIP spacing) on the level that ordinary mip-mapping takes.
TEST(reference_vertex_based, bias_of_the_level_of_detail) {
  const MipMap map = level_map(1024, 1024);
  const Gradients<double> g{{64, 0}, {0, 16}};
  for (const ProbePattern& pattern : patterns()) {
    Cost cost;
    const auto lookup = lookup_at(map.base(), 500, 500, g);
    const auto got = vertex_based_filter(map, pattern, blend_alphas(pattern.weights), lookup.gradients, lookup, cost);
    EXPECT_NEAR(got[0], 6 + std::log2(pattern.spacing), 1e-12);
    EXPECT_EQ(cost.probes, static_cast<double>(pattern.probes.size()));
  }
}

// Each pass an ordinary trilinear probe at coordinates moved by both axes; blending equals the weighted sum. In the
// Screen system that is "implementing screen-based super-sampling": the texture coordinates of points of the screen.
TEST(reference_vertex_based, passes_blend_to_the_weighted_sum) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_vertex_based.passes_blend_to_the_weighted_sum");
  const MipMap map = box_map(noise_level(64, 32, random), {Wrap::kMirroredRepeat, Wrap::kRepeat, {}});
  for (int round = 0; round < 500; ++round) {
    const auto g = random_gradients(random, log_uniform(random, 0, 1.5), log_uniform(random, -1, 1));
    const double u = random.real(-90, 90);
    const double v = random.real(-90, 90);
    const auto lookup = lookup_at(map.base(), u, v, g);
    const double level = std::log2(std::max(length(g.x), length(g.y)));
    for (const ProbePattern& pattern : patterns()) {
      Colour want{};
      for (std::size_t i = 0; i < pattern.probes.size(); ++i) {
        const auto [x, y] = pattern.probes[i];  // in pixels of the screen
        add_weighted(want, pattern.weights[i],
                     trilinear_sample(map, level + std::log2(pattern.spacing), (u + x * g.x.u + y * g.y.u) / 64,
                                      (v + x * g.x.v + y * g.y.v) / 32));
      }
      Cost cost;
      const auto axes = vertex_axes(AxisSystem::kScreen, lookup.gradients, map.base());
      const auto got = vertex_based_filter(map, pattern, blend_alphas(pattern.weights), axes, lookup, cost);
      EXPECT_LE(distance(got, want), 1e-12);
    }
  }
}

}  // namespace
}  // namespace feline::reference
