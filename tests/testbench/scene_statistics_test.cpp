// SPDX-License-Identifier: Apache-2.0
// What each scene is for, in figures of its lookups.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "testbench/scenes/scene.h"

namespace feline {
namespace {

// The ellipse of a pixel in texels of level 0: singular values of the gradients' matrix.
struct Footprint {
  double major;
  double minor;
  double cosine;  // between the gradients, 0 when square
};

Footprint footprint(const Lookup& lookup, const MipLevel& level) {
  const double a = double{lookup.dsdx} * level.width;
  const double b = double{lookup.dtdx} * level.height;
  const double c = double{lookup.dsdy} * level.width;
  const double d = double{lookup.dtdy} * level.height;
  const double sum = a * a + b * b + c * c + d * d;
  const double area = std::abs(a * d - b * c);
  const double major = std::sqrt((sum + std::sqrt(std::max(0.0, sum * sum - 4 * area * area))) / 2);
  const double lengths = std::sqrt((a * a + b * b) * (c * c + d * d));
  return {major, area / major, std::abs(a * c + b * d) / lengths};
}

struct Statistics {
  double anisotropy_50 = 0;  // median
  double anisotropy_95 = 0;  // 95th percentile
  double anisotropy_max = 0;
  double leaning = 0;    // part of the pairs more than 30 degrees off square
  double major_max = 0;  // texels
};

Statistics measure(const Scene& scene, int size) {
  const MipLevel level = scene.paint();
  std::vector<double> anisotropies;
  Statistics statistics;
  const GBuffer gbuffer = make_gbuffer(scene, size, size);
  for (const Lookup& lookup : gbuffer.lookups) {
    const Footprint pixel = footprint(lookup, level);
    anisotropies.push_back(pixel.major / pixel.minor);
    statistics.leaning += pixel.cosine > 0.5 ? 1.0 / (size * size) : 0.0;
    statistics.major_max = std::max(statistics.major_max, pixel.major);
  }
  std::ranges::sort(anisotropies);
  statistics.anisotropy_50 = anisotropies[anisotropies.size() / 2];
  statistics.anisotropy_95 = anisotropies[anisotropies.size() * 95 / 100];
  statistics.anisotropy_max = anisotropies.back();
  return statistics;
}

Statistics measure(std::string_view name, int size) { return measure(find_scene(name), size); }

TEST(scene_statistics, ground_anisotropy_reaches_what_the_slope_says) {
  const Statistics bricks = measure("bricks", 256);
  EXPECT_GT(bricks.anisotropy_max, 16);
  EXPECT_LT(bricks.anisotropy_max, 22);
  EXPECT_GT(measure("runway", 256).anisotropy_max, 15);
  EXPECT_GT(measure("text", 256).anisotropy_max, 8);
  EXPECT_NEAR(measure("tessellated", 256).anisotropy_95, 7.7, 0.2);
}

// Olano et al. 2001, figure 1: filters of 2, 4, 8 and 16 samples part at one pitch angle after the other.
TEST(scene_statistics, runway_at_four_pitch_angles) {
  EXPECT_NEAR(measure("runway_steep", 256).anisotropy_95, 2.1, 0.1);
  EXPECT_NEAR(measure("runway_middle", 256).anisotropy_95, 4.9, 0.1);
  EXPECT_NEAR(measure("runway", 256).anisotropy_95, 11, 0.2);
  EXPECT_NEAR(measure("runway_low", 256).anisotropy_95, 18.4, 0.2);
}

TEST(scene_statistics, window_is_extreme) {
  const Statistics window = measure("window", 256);
  EXPECT_GT(window.leaning, 0.5);
  EXPECT_GT(window.anisotropy_95, 20);
}

// As the rippled sphere of the measured peers: 61 % leaning, 95th percentile 34.
TEST(scene_statistics, sphere_leans) {
  const Statistics sphere = measure("sphere", 256);
  EXPECT_GT(sphere.leaning, 0.5);
  EXPECT_GT(sphere.anisotropy_95, 20);
}

TEST(scene_statistics, magnify_is_eight_times_at_512) { EXPECT_NEAR(measure("magnify", 512).major_max, 1.0 / 8, 1e-6); }

TEST(scene_statistics, reflector_distorts_and_leans) {
  const Statistics reflector = measure("reflector", 256);
  EXPECT_GT(reflector.leaning, 0.5);
  EXPECT_GT(reflector.anisotropy_95, 20);
}

// The singular point of the sphere map is the circle of radius 1/2 about the middle.
TEST(scene_statistics, reflector_keeps_off_the_rim_of_the_sphere_map) {
  double farthest = 0;
  for (const Lookup& lookup : make_gbuffer(find_scene("reflector"), 256, 256).lookups) {
    farthest = std::max(farthest, std::hypot(lookup.s - 0.5, lookup.t - 0.5));
  }
  EXPECT_LT(farthest, 0.35);
  EXPECT_GT(farthest, 0.25);  // half of the radius and more: the environment is seen, not one corner of it
}

// At the upper edge even the short axis spans a whole repeat, so that every filter ends at 1 x 1 texels.
TEST(scene_statistics, repeat_spans_the_whole_chain) {
  const Scene& scene = find_scene("repeat");
  const MipLevel level = scene.paint();
  EXPECT_EQ(level.width, 64);
  EXPECT_EQ(level.height, 64);
  constexpr std::size_t kSize = 512;
  const GBuffer gbuffer = make_gbuffer(scene, kSize, kSize);
  for (std::size_t column = 0; column < kSize; ++column) {
    EXPECT_GT(footprint(gbuffer.lookups[column], level).minor, 64) << column;
    const Lookup& low = gbuffer.lookups[(kSize - 1) * kSize + column];
    EXPECT_LT(footprint(low, level).major, 1.5) << column;
    EXPECT_GT(footprint(low, level).minor, 0.5) << column;
  }
}

TEST(scene_statistics, spin_is_eight_times_foreshortened_in_every_frame) {
  for (int i = 0; i < 8; ++i) {
    const Statistics still = measure(frame(find_scene("spin"), i), 128);
    EXPECT_NEAR(still.anisotropy_50, 7.7, 0.1);
    EXPECT_LT(still.anisotropy_max, 10.6);
    EXPECT_LT(still.major_max, 4 * 15.6);  // texels; at 512 x 512 a fourth
  }
}

TEST(scene_statistics, spin_moves_four_pixels_a_frame_at_most) {
  constexpr int kSize = 512;
  const Scene& spin = find_scene("spin");
  double farthest = 0;
  for (int i = 0; i < 7; ++i) {
    const GBuffer before = make_gbuffer(frame(spin, i), kSize, kSize);
    const GBuffer after = make_gbuffer(frame(spin, i + 1), kSize, kSize);
    for (std::size_t pixel = 0; pixel < before.lookups.size(); ++pixel) {
      const Lookup& from = before.lookups[pixel];
      const Lookup& to = after.lookups[pixel];
      // The step in the texture, undone by the gradients: a step in the picture.
      const double s = double{to.s} - double{from.s};
      const double t = double{to.t} - double{from.t};
      const double area = double{from.dsdx} * from.dtdy - double{from.dsdy} * from.dtdx;
      const double x = (s * from.dtdy - t * from.dsdy) / area;
      const double y = (t * from.dsdx - s * from.dtdx) / area;
      farthest = std::max(farthest, std::hypot(x, y));
    }
    const std::size_t middle = kSize / 2 * kSize + kSize / 2;
    EXPECT_NEAR(before.lookups[middle].s, after.lookups[middle].s, 1e-4);
    EXPECT_NEAR(before.lookups[middle].t, after.lookups[middle].t, 1e-4);
  }
  EXPECT_LT(farthest, 4);
  EXPECT_GT(farthest, 3);
}

}  // namespace
}  // namespace feline
