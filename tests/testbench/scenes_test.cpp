// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "testbench/scenes/font.h"
#include "testbench/scenes/perspective.h"
#include "testbench/scenes/scene.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

constexpr std::array<std::string_view, 8> kNames = {"bricks", "curves", "text",   "checkerboard",
                                                    "runway", "window", "sphere", "magnify"};

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
  double anisotropy_95 = 0;  // 95th percentile
  double anisotropy_max = 0;
  double leaning = 0;    // part of the pairs more than 30 degrees off square
  double major_max = 0;  // texels
};

Statistics measure(std::string_view name, int size) {
  const Scene& scene = find_scene(name);
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
  statistics.anisotropy_95 = anisotropies[anisotropies.size() * 95 / 100];
  statistics.anisotropy_max = anisotropies.back();
  return statistics;
}

TEST(scenes, names_and_lookup) {
  ASSERT_EQ(scenes().size(), kNames.size());
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    EXPECT_EQ(scenes()[i].name, kNames[i]);
    EXPECT_EQ(&find_scene(kNames[i]), &scenes()[i]);
    EXPECT_FALSE(scenes()[i].description.empty());
  }
  EXPECT_EQ(input_error([] { find_scene("brick"); }),
            "scene: name: got brick, legal is bricks, curves, text, checkerboard, runway, window, "
            "sphere, magnify");
}

// Analytic against central differences in double, at points off any pixel grid.
TEST(scenes, derivatives_match_finite_differences) {
  constexpr double kStep = 1e-6;
  for (const Scene& scene : scenes()) {
    const auto value = [&](double x, double y) { return scene.project(Dual(x), Dual(y)); };
    for (double y = 0.013; y < 1; y += 0.0371) {
      for (double x = 0.017; x < 1; x += 0.0413) {
        const TexturePoint at = scene.project(Dual(x, 1, 0), Dual(y, 0, 1));
        const auto slope = [](const Dual& high, const Dual& low) { return (high.value - low.value) / (2 * kStep); };
        const TexturePoint right = value(x + kStep, y);
        const TexturePoint left = value(x - kStep, y);
        const TexturePoint below = value(x, y + kStep);
        const TexturePoint above = value(x, y - kStep);
        const double scale = 1 + std::abs(at.s.dx) + std::abs(at.s.dy) + std::abs(at.t.dx) + std::abs(at.t.dy);
        ASSERT_NEAR(at.s.dx, slope(right.s, left.s), 1e-5 * scale) << scene.name << x << " " << y;
        ASSERT_NEAR(at.t.dx, slope(right.t, left.t), 1e-5 * scale) << scene.name << x << " " << y;
        ASSERT_NEAR(at.s.dy, slope(below.s, above.s), 1e-5 * scale) << scene.name << x << " " << y;
        ASSERT_NEAR(at.t.dy, slope(below.t, above.t), 1e-5 * scale) << scene.name << x << " " << y;
      }
    }
  }
}

TEST(scenes, every_lookup_is_finite_and_moderate) {
  for (const Scene& scene : scenes()) {
    for (const auto& [width, height] : {std::pair{128, 128}, {97, 31}, {1, 1}}) {
      const GBuffer gbuffer = make_gbuffer(scene, width, height);
      ASSERT_EQ(gbuffer.lookups.size(), static_cast<std::size_t>(width * height));
      for (const Lookup& l : gbuffer.lookups) {
        for (const float value : {l.s, l.t, l.dsdx, l.dtdx, l.dsdy, l.dtdy}) {
          ASSERT_TRUE(std::isfinite(value)) << scene.name;
        }
        // Beyond 64 repeats float32 would have less than the unit's 8 sub-texel bits at 1024 texels.
        ASSERT_LT(std::abs(l.s), 64.0f) << scene.name;
        ASSERT_LT(std::abs(l.t), 64.0f) << scene.name;
      }
    }
  }
}

// A pixel of 3 x 5 covers 3 x 5 of 9 x 25; its centre is the centre of the middle one.
TEST(scenes, resolution_changes_the_pixels_only) {
  for (const Scene& scene : scenes()) {
    const GBuffer coarse = make_gbuffer(scene, 3, 5);
    const GBuffer fine = make_gbuffer(scene, 9, 25);
    for (std::size_t row = 0; row < 5; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        const Lookup& large = coarse.lookups[row * 3 + column];
        const Lookup& small = fine.lookups[(5 * row + 2) * 9 + 3 * column + 1];
        const auto near = [&](float a, float b) { EXPECT_NEAR(a, b, 1e-5 * (1 + std::abs(a))) << scene.name; };
        near(large.s, small.s);
        near(large.t, small.t);
        near(large.dsdx, 3 * small.dsdx);
        near(large.dtdx, 3 * small.dtdx);
        near(large.dsdy, 5 * small.dsdy);
        near(large.dtdy, 5 * small.dtdy);
      }
    }
  }
}

TEST(scenes, textures) {
  for (const Scene& scene : scenes()) {
    const MipLevel base = scene.paint();
    ASSERT_EQ(base.texels.size(), static_cast<std::size_t>(base.width * base.height * bytes_per_texel(scene.format)));
    const std::set<std::uint8_t> values(base.texels.begin(), base.texels.end());
    EXPECT_GT(values.size(), 8u) << scene.name << " is nearly blank";
  }
  EXPECT_TRUE(find_scene("bricks").srgb);
  EXPECT_EQ(find_scene("text").format, TexelFormat::kR8);
  const Texture window = find_scene("window").texture(MipFilter::kBox);
  EXPECT_EQ(window.levels.size(), 10u);
  EXPECT_EQ(window.levels[0].width, 600);
  EXPECT_EQ(window.levels[0].height, 840);
  EXPECT_EQ(window.levels[9].width, 1);
}

TEST(scenes, ground_anisotropy_reaches_what_the_slope_says) {
  const Statistics bricks = measure("bricks", 256);
  EXPECT_GT(bricks.anisotropy_max, 16);
  EXPECT_LT(bricks.anisotropy_max, 22);
  EXPECT_GT(measure("runway", 256).anisotropy_max, 15);
  EXPECT_GT(measure("text", 256).anisotropy_max, 8);
}

TEST(scenes, window_is_extreme) {
  const Statistics window = measure("window", 256);
  EXPECT_GT(window.leaning, 0.5);
  EXPECT_GT(window.anisotropy_95, 20);
}

// As the rippled sphere of the measured peers: 61 % leaning, 95th percentile 34.
TEST(scenes, sphere_leans) {
  const Statistics sphere = measure("sphere", 256);
  EXPECT_GT(sphere.leaning, 0.5);
  EXPECT_GT(sphere.anisotropy_95, 20);
}

TEST(scenes, magnify_is_eight_times_at_512) { EXPECT_NEAR(measure("magnify", 512).major_max, 1.0 / 8, 1e-6); }

// A square seen from the side: half of the depth range is not half of the screen.
TEST(scenes, interpolation_is_perspective_correct) {
  const PerspectiveTriangle triangle({{{0, 0, 1, 0, 0}, {1, 0, 3, 1, 0}, {0, 1, 1, 0, 1}}});
  const TexturePoint middle = triangle.interpolate(Dual(0.5), Dual(0.0));
  EXPECT_DOUBLE_EQ(middle.s.value, 0.25);  // (0/1 + 1/3) / (1/1 + 1/3)
  EXPECT_DOUBLE_EQ(triangle.interpolate(Dual(1.0), Dual(0.0)).s.value, 1.0);
  EXPECT_DOUBLE_EQ(triangle.interpolate(Dual(0.0), Dual(0.5)).t.value, 0.5);
  EXPECT_TRUE(triangle.covers(0.25, 0.25));
  EXPECT_FALSE(triangle.covers(0.75, 0.75));
}

TEST(scenes, font_has_every_letter_and_no_two_alike) {
  std::set<Glyph> glyphs;
  for (char c = ' '; c <= 'z'; ++c) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (letter || std::string_view(" .,:;!?'()-+/=").find(c) != std::string_view::npos) {
      EXPECT_TRUE(glyphs.insert(glyph(c)).second) << c;
      EXPECT_NE(glyph(c), glyph('\x7f')) << c;
    }
  }
}

TEST(scenes, size_limits) {
  EXPECT_EQ(input_error([] { make_gbuffer(find_scene("text"), 0, 4); }),
            "scene text: width: got 0, legal is 1 to 16384");
  EXPECT_EQ(input_error([] { make_gbuffer(find_scene("text"), 4, 16385); }),
            "scene text: height: got 16385, legal is 1 to 16384");
}

}  // namespace
}  // namespace feline
