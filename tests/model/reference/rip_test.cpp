// SPDX-License-Identifier: Apache-2.0
#include "model/reference/rip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random.h"
#include "tests/support/reference_images.h"
#include "tests/support/reference_sampling.h"

namespace feline::reference {
namespace {

// Image (i, j) is as bright as i + 16 j: the colour tells which images were read.
RipMap numbered_map(int width, int height) {
  return rip_of(width, height, kRepeated, [](double, double, int i, int j) { return grey(i + 16 * j); });
}

double pixel(const RipMap& map, const Gradients<double>& g, double u = 9.3, double v = 4.1) {
  Cost cost;
  return rip_pixel_filter(map, lookup_at(map.at(0, 0), u, v, g), cost)[0];
}

// A footprint of 2^i by 2^j texels along the axes reads the image that is halved i times in s and j times in t.
TEST(reference_rip, pixel_picks_the_image_of_the_footprint) {
  const RipMap map = numbered_map(64, 16);
  ASSERT_EQ(map.columns, 7);
  ASSERT_EQ(map.rows, 5);
  for (int i = 0; i < 7; ++i) {
    for (int j = 0; j < 5; ++j) {
      const double width = std::ldexp(1.0, i);
      const double height = std::ldexp(1.0, j);
      EXPECT_NEAR(pixel(map, {{width, 0}, {0, height}}), i + 16 * j, 1e-13);
      EXPECT_NEAR(pixel(map, {{0, -height}, {-width, 0}}), i + 16 * j, 1e-13);  // either way round
    }
  }
  EXPECT_EQ(pixel(map, {{1e6, 0}, {0, 1e6}}), 6 + 16 * 4);
  EXPECT_EQ(pixel(map, {{0.1, 0}, {0, 0.1}}), 0);
  EXPECT_EQ(pixel(map, {}), 0);
  // At 45 degrees it is as wide in s as in t: "as poorly as MIP mapping along the texture diagonal" (Olano, 1.1).
  EXPECT_NEAR(pixel(map, {{8, 8}, {-0.5, 0.5}}), 3 + 16 * 3, 1e-12);
}

// Between the powers of two four images are blended, linearly in each level.
TEST(reference_rip, pixel_blends_four_images) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_rip.pixel_blends_four_images");
  const RipMap numbers = numbered_map(64, 32);
  const RipMap noise = rip_of(64, 32, {Wrap::kRepeat, Wrap::kMirroredRepeat, {}},
                              [&](double, double, int, int) { return grey(random.unit()); });
  for (int round = 0; round < 5000; ++round) {
    const auto g = random_gradients(random, log_uniform(random, -1, 2), log_uniform(random, -1, 2));
    const double s_level = std::clamp(std::log2(std::max(std::abs(g.x.u), std::abs(g.y.u))), 0.0, 6.0);
    const double t_level = std::clamp(std::log2(std::max(std::abs(g.x.v), std::abs(g.y.v))), 0.0, 5.0);
    const double u = random.real(-100, 100);
    const double v = random.real(-100, 100);
    EXPECT_NEAR(pixel(numbers, g, u, v), s_level + 16 * t_level, 1e-12);
    const RipLevel level = rip_level(noise, lookup_at(noise.at(0, 0), u, v, g));
    EXPECT_NEAR(std::min(level.s, 6.0), s_level, 1e-12);
    EXPECT_NEAR(std::min(level.t, 5.0), t_level, 1e-12);
    const int i = static_cast<int>(s_level);
    const int j = static_cast<int>(t_level);
    const auto at = [&](int column, int row) {
      return tent_sample(noise.at(std::min(column, 6), std::min(row, 5)), noise.wrapping, u / 64, v / 32);
    };
    const auto want =
        mix(mix(at(i, j), at(i + 1, j), s_level - i), mix(at(i, j + 1), at(i + 1, j + 1), s_level - i), t_level - j);
    EXPECT_NEAR(pixel(noise, g, u, v), want[0], 1e-12);
  }
}

// The demo's two loops: how many halvings bring the ground resolution in each direction to a texel.
int demo_rip(double ground_y, double ground_x) {
  int rip = 0;
  while (ground_y > 1) {
    ground_y *= 0.5;
    rip++;
  }
  while (ground_x > 1) {
    ground_x *= 0.5;
    rip--;
  }
  return rip;
}

// "Select a texture ID which best represents the ratio of s/t", of the polygon's middle, whatever the pixel is; then
// that image is mip-mapped: k halvings more of both its sides, k the log2 of the longer gradient in its texels.
TEST(reference_rip, polygon_takes_the_demos_ratio) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_rip.polygon_takes_the_demos_ratio");
  const RipMap map = numbered_map(256, 256);
  for (int round = 0; round < 10000; ++round) {
    const Gradients<double> middle{{log_uniform(random, -1, 1.2), 0}, {0, log_uniform(random, -1, 1.2)}};
    const bool turned = random.one_in(2);
    const Gradients<double> given = turned ? Gradients<double>{middle.y, middle.x} : middle;
    const int rip = std::clamp(demo_rip(middle.y.v, middle.x.u), -8, 8);
    const int i = std::max(-rip, 0);
    const int j = std::max(rip, 0);
    const auto g = random_gradients(random, log_uniform(random, -1, 1), log_uniform(random, -1, 1));
    const auto shrunk = [&](const Vector2<double>& d) { return std::hypot(std::ldexp(d.u, -i), std::ldexp(d.v, -j)); };
    const double most = 8 - std::max(i, j);
    const double level = std::clamp(std::log2(std::max(shrunk(g.x), shrunk(g.y))), 0.0, most);
    Cost cost;
    const double got =
        rip_polygon_filter(map, lookup_at(map.at(0, 0), 3, 200, given),
                           lookup_at(map.at(0, 0), random.real(0, 256), random.real(0, 256), g), cost)[0];
    EXPECT_NEAR(got, i + level + 16 * (j + level), 1e-11) << i << " " << j << " " << level;
    EXPECT_EQ(cost.probes, 1);
  }
}

// The demo's own picture: the runway recedes along t.
TEST(reference_rip, runway) {
  const RipMap map = numbered_map(256, 256);
  const auto polygon = [&](const Gradients<double>& g) {
    Cost cost;
    const auto lookup = lookup_at(map.at(0, 0), 50, 50, g);
    return rip_polygon_filter(map, lookup, lookup, cost)[0];
  };
  EXPECT_EQ(polygon({{1, 0}, {0, 8}}), 16 * 3);       // 1 x 8 texels: halved thrice in t
  EXPECT_EQ(polygon({{2, 0}, {0, 16}}), 1 + 16 * 4);  // twice as far: the same image, its second level
  EXPECT_EQ(polygon({{16, 0}, {0, 2}}), 4 + 16 * 1);
  EXPECT_EQ(polygon({{4, 0}, {0, 4}}), 2 + 16 * 2);
}

TEST(reference_rip, ramps_are_exact) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_rip.ramps_are_exact");
  const RipMap map =
      rip_of(256, 128, kClamped, [](double s, double t, int, int) { return ramp_texel(s, t, 256, 128); });
  for (int i = 0; i < 2000; ++i) {
    const double u = random.real(100, 156);
    const double v = random.real(50, 78);
    const auto lookup = lookup_at(map.at(0, 0), u, v, random_gradients(random, log_uniform(random, -1, 1), 0.7));
    Cost cost;
    for (const auto& got : {rip_pixel_filter(map, lookup, cost), rip_polygon_filter(map, lookup, lookup, cost)}) {
      EXPECT_NEAR(got[0], u / 1024, 1e-13);
      EXPECT_NEAR(got[1], v / 1024, 1e-13);
    }
  }
}

}  // namespace
}  // namespace feline::reference
