// SPDX-License-Identifier: Apache-2.0
#include "model/reference/texram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/reference/ellipse.h"
#include "tests/support/measured.h"
#include "tests/support/random.h"
#include "tests/support/reference_lines.h"

namespace feline::reference {
namespace {

// WRL 99/1, 2.3: [1, 1.5) one probe, [1.5, 3) two, [3, 6) four, "etc."
TEST(reference_texram, rounding) {
  struct Range {
    double from, to;
    int probes;
  };
  for (const auto& [from, to, probes] :
       {Range{1, 1.5, 1}, {1.5, 3, 2}, {3, 6, 4}, {6, 12, 8}, {12, 24, 16}, {24, 1e9, 16}}) {
    EXPECT_EQ(round_texram_probes(from, 16), probes);
    EXPECT_EQ(round_texram_probes((from + to) / 2, 16), probes);
    EXPECT_EQ(round_texram_probes(std::nextafter(to, 0), 16), probes);
    EXPECT_EQ(round_texram_probes(from, 4), std::min(probes, 4));
  }
  EXPECT_EQ(round_texram_probes(24, 64), 32);
  EXPECT_EQ(round_texram_probes(1e30, 16), 16);
  EXPECT_EQ(round_texram_probes(INFINITY, 16), 16);
}

// At least a texel, as in 3.1; 2.3 says nothing of magnification.
double shortest(const Gradients<double>& g) {
  return std::max(1.0, std::min({std::hypot(g.x.u, g.x.v), std::hypot(g.y.u, g.y.v),
                                 std::hypot(g.x.u + g.y.u, g.x.v + g.y.v), std::hypot(g.x.u - g.y.u, g.x.v - g.y.v)}));
}
double longest(const Gradients<double>& g) { return std::max(std::hypot(g.x.u, g.x.v), std::hypot(g.y.u, g.y.v)); }

// 2.3's example: 13/sqrt(26) = 2.55 rounds to two probes, as wide as the diagonal (1, -5). Both vectors are 13 long; on
// a tie y is the longer one.
TEST(reference_texram, the_papers_example) {
  const ProbeLine line = plan_texram({{13, 0}, {12, 5}}, 16);
  EXPECT_EQ(line.probes, 2);
  EXPECT_EQ(line.step.u, 12.0 / 2);
  EXPECT_EQ(line.step.v, 5.0 / 2);
  EXPECT_NEAR(line.level_of_detail, std::log2(std::sqrt(26.0)), 1e-14);
  EXPECT_EQ(line.falloff, 0);
}

TEST(reference_texram, plans_of_any_gradients) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_texram.plans_of_any_gradients");
  double widest_angle = 0;
  double widest_line = 0;
  for (int i = 0; i < 200000; ++i) {
    const double major = log_uniform(random, -1, 2);
    const auto g = random_gradients(random, major, major * (i % 2 == 0 ? random.unit() : random.real(0.99, 1)));
    const ProbeLine line = plan_texram(g, 16);
    const double ratio = longest(g) / shortest(g);
    int probes = 1;
    for (double up_to = 1.5; ratio >= up_to && probes < 16; up_to *= 2) probes *= 2;
    EXPECT_EQ(line.probes, probes);
    EXPECT_EQ(line.falloff, 0);
    // At the limit of 16 probes, of which 2.3 says nothing, as wide as the line asks.
    EXPECT_NEAR(line.level_of_detail, std::log2(ratio < 24 ? shortest(g) : longest(g) / 16), 1e-12);
    const Vector2<double> longer = length(g.x) > length(g.y) ? g.x : g.y;
    const double angle = angle_between_lines(longer, ellipse_axes(g).major);
    widest_angle = std::max(widest_angle, angle);
    if (probes == 1) continue;
    EXPECT_EQ(angle_between_lines(line.step, longer), 0);
    EXPECT_NEAR(probes * length(line.step), longest(g), 1e-12 * longest(g));  // the line is as long as the vector
    widest_line = std::max(widest_line, angle);
  }
  measured("widest_angle", widest_angle * 180 / std::numbers::pi);
  measured("widest_line", widest_line * 180 / std::numbers::pi);
  // "By as much as 45 degrees", of circles nearly, which take one probe. A line of probes turns by half as much.
  EXPECT_LE(widest_angle, std::numbers::pi / 4);
  EXPECT_GE(widest_angle, 0.98 * std::numbers::pi / 4);
  EXPECT_LE(widest_line, std::numbers::pi / 8);
}

// "Texram's sampling line can be shorter than the true ellipse's major axis by nearly a factor of four." It is a factor
// of two, radius for diameter, times one of sqrt(2), and not of two: the larger eigenvalue of M M^T is at most its
// trace, the sum of both squared lengths, which nearly parallel vectors of equal length reach.
TEST(reference_texram, line_is_shorter_than_the_diameter) {
  double most = 0;
  double least = 100;
  for (double ratio = 0.01; ratio <= 1; ratio += 0.01) {
    for (double angle = 0.001; angle < std::numbers::pi; angle += 0.01) {
      const Gradients<double> g{{90, 0}, {90 * ratio * std::cos(angle), 9 * ratio * std::sin(angle)}};
      const ProbeLine line = plan_texram(g, 16);
      if (line.probes == 1) continue;
      const double factor = 2 * ellipse_axes(g).major_radius / (line.probes * length(line.step));
      most = std::max(most, factor);
      least = std::min(least, factor);
    }
  }
  measured("most", most);
  EXPECT_GE(least, 2 - 1e-12);
  EXPECT_LE(most, 2 * std::sqrt(2.0));
  EXPECT_GE(most, 0.99 * 2 * std::sqrt(2.0));
}

// "If the side vectors are nearly parallel and the shorter is half the length of the longer, this approximation can be
// too wide by an arbitrarily large factor."
TEST(reference_texram, probes_too_wide_by_any_factor) {
  for (const double height : {1e-2, 1e-5, 1e-9}) {
    const Gradients<double> g{{16, 0}, {8, height}};
    EXPECT_NEAR(std::exp2(plan_texram(g, 16).level_of_detail), 8, 1e-2);
    EXPECT_LE(ellipse_axes(g).minor_radius, height);
  }
}

TEST(reference_texram, filter_is_the_mean_of_its_probes) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_texram.filter_is_the_mean_of_its_probes");
  const MipMap map = box_map(noise_level(64, 128, random), {Wrap::kMirroredRepeat, Wrap::kRepeat, {}});
  for (int i = 0; i < 3000; ++i) {
    const double major = log_uniform(random, 0, 1.8);
    const auto g = random_gradients(random, major, major * random.real(0.09, 1));
    if (longest(g) >= 24 * shortest(g)) continue;
    int probes = 1;
    for (double up_to = 1.5; longest(g) / shortest(g) >= up_to; up_to *= 2) probes *= 2;
    probes = std::min(probes, 16);
    const auto& longer = std::hypot(g.x.u, g.x.v) > std::hypot(g.y.u, g.y.v) ? g.x : g.y;
    const double u = random.real(-200, 200);
    const double v = random.real(-200, 200);
    Cost cost;
    const auto got = texram_filter(map, 16, lookup_at(map.base(), u, v, g), cost);
    const auto want = sum_probes(map, probes, u, v, (1.0 / probes) * longer, std::log2(shortest(g)), kEqualWeights);
    EXPECT_LE(distance(got, want), 1e-12);
    EXPECT_EQ(cost.probes, probes);
    EXPECT_EQ(cost.cycles, probes);
  }
}

TEST(reference_texram, degenerate_gradients) {
  const ProbeLine line = plan_texram({{64, 0}, {0, 0}}, 16);
  EXPECT_EQ(line.probes, 16);
  EXPECT_NEAR(length(line.step), 4, 1e-14);
  const ProbeLine none = plan_texram({}, 16);
  EXPECT_GE(none.probes, 1);
  EXPECT_LE(none.probes, 16);
  EXPECT_FALSE(std::isnan(none.level_of_detail));
  EXPECT_EQ(length(none.step), 0);
}

}  // namespace
}  // namespace feline::reference
