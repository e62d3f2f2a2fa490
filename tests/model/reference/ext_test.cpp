// SPDX-License-Identifier: Apache-2.0
#include "model/reference/ext.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/random.h"
#include "tests/support/reference_lines.h"

namespace feline::reference {
namespace {

void expect_plan(const Gradients<double>& g, int max_anisotropy, int probes, double level,
                 const Vector2<double>& step) {
  const ProbeLine line = plan_ext(g, max_anisotropy);
  EXPECT_EQ(line.probes, probes);
  EXPECT_NEAR(line.level_of_detail, level, 1e-14);
  EXPECT_EQ(line.falloff, 0);
  if (probes == 1) return;
  EXPECT_NEAR(line.step.u, step.u, 1e-14);
  EXPECT_NEAR(line.step.v, step.v, 1e-14);
}

// N = min(ceil(Pmax/Pmin), maxAniso), lambda = log2(Pmax/N), probes a 1/(N + 1) of the longer gradient apart.
TEST(reference_ext, plans_by_hand) {
  expect_plan({{8, 0}, {0, 2}}, 16, 4, 1, {8.0 / 5, 0});
  expect_plan({{4, 0}, {0, 3}}, 16, 2, 1, {4.0 / 3, 0});           // ceil(4/3)
  expect_plan({{0, 3}, {-4, 0}}, 16, 2, 1, {-4.0 / 3, 0});         // y is the longer one
  expect_plan({{6, 8}, {0, 1}}, 16, 10, 0, {6.0 / 11, 8.0 / 11});  // Px = 10
  expect_plan({{6, 8}, {0, 1}}, 5, 5, 1, {1, 8.0 / 6});            // at most maxAniso
  expect_plan({{6, 8}, {0, 1}}, 1, 1, std::log2(10), {});          // 1: isotropic
  expect_plan({{32, 0}, {0, 0}}, 16, 16, 1, {32.0 / 17, 0});       // Pmin = 0
  expect_plan({{0, 0}, {0, 32}}, 8, 8, 2, {0, 32.0 / 9});          //
  expect_plan({{3, 4}, {0, 5}}, 16, 1, std::log2(5), {});          // a tie is one probe
  expect_plan({{5.125, 0}, {0, 5}}, 16, 2, std::log2(5.125 / 2), {5.125 / 3, 0});
  EXPECT_EQ(plan_ext({{3, 4}, {0, 5}}, 16).step.u, 0);  // along y: Px > Py is strict
  const ProbeLine none = plan_ext({}, 16);
  EXPECT_GE(none.probes, 1);
  EXPECT_LE(none.probes, 16);
  EXPECT_FALSE(std::isnan(none.level_of_detail));
  EXPECT_EQ(none.step.u, 0);
  EXPECT_EQ(none.step.v, 0);
}

// The extension's sum: Tau(u + dudx(i/(N+1) - 1/2), v + dvdx(i/(N+1) - 1/2)), i = 1 .. N.
TEST(reference_ext, filter_is_the_extensions_sum) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_ext.filter_is_the_extensions_sum");
  const MipMap map = box_map(noise_level(128, 64, random), {Wrap::kRepeat, Wrap::kMirroredRepeat, {}});
  for (int round = 0; round < 3000; ++round) {
    const auto g = random_gradients(random, log_uniform(random, 0, 1.8), log_uniform(random, -1, 1));
    const double px = std::hypot(g.x.u, g.x.v);
    const double py = std::hypot(g.y.u, g.y.v);
    const int most = static_cast<int>(random.between(1, 16));
    const int n = static_cast<int>(std::min(std::ceil(std::max(px, py) / std::min(px, py)), static_cast<double>(most)));
    const auto& longer = px > py ? g.x : g.y;
    const double u = random.real(-200, 200);
    const double v = random.real(-200, 200);
    Colour want{};
    for (int i = 1; i <= n; ++i) {
      const double at = static_cast<double>(i) / (n + 1) - 0.5;
      add_weighted(
          want, 1.0 / n,
          trilinear_sample(map, std::log2(std::max(px, py) / n), (u + longer.u * at) / 128, (v + longer.v * at) / 64));
    }
    Cost cost;
    EXPECT_LE(distance(ext_filter(map, most, lookup_at(map.base(), u, v, g), cost), want), 1e-12);
    EXPECT_EQ(cost.probes, n);
    EXPECT_EQ(cost.cycles, n);
  }
}

// Along a slow wave of w radians a texel, N equal probes a step s apart pass sin(N w s/2) / (N sin(w s/2)) of it, and
// linear interpolation loses w^2/8 at most.
TEST(reference_ext, line_of_a_wave) {
  const double w = 2 * std::numbers::pi / 256;
  const MipMap map =
      map_of(256, 1, kRepeated, [](double s, double, int) { return grey(std::cos(2 * std::numbers::pi * s)); });
  for (const double longer : {3.0, 10.0, 25.0, 40.0}) {
    const double n = std::ceil(longer / 3);
    const double phase = n == 1 ? 0 : w * longer / (n + 1) / 2;
    const double pass = n == 1 ? 1 : std::sin(n * phase) / (n * std::sin(phase));
    const double coarse = w * std::exp2(std::ceil(std::log2(longer / n)));
    for (double u = 0; u < 256; u += 7.3) {
      Cost cost;
      const double got = ext_filter(map, 16, lookup_at(map.base(), u, 0.5, {{longer, 0}, {0, 3}}), cost)[0];
      EXPECT_NEAR(got, pass * std::cos(w * u), coarse * coarse / 8 + 1e-7) << longer << " " << u;
    }
  }
}

}  // namespace
}  // namespace feline::reference
