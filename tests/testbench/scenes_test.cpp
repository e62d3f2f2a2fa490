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

constexpr std::array<std::string_view, 15> kSceneNames = {
    "bricks", "curves", "text",      "checkerboard", "runway_steep", "runway_middle", "runway", "runway_low",
    "window", "sphere", "reflector", "magnify",      "repeat",       "tessellated",   "spin"};

// Every frame of every scene.
std::vector<Scene> all_stills() {
  std::vector<Scene> stills;
  for (const Scene& scene : scenes()) {
    for (int i = 0; i < frame_count(scene); ++i) stills.push_back(frame(scene, i));
  }
  return stills;
}

TEST(scenes, names_and_lookup) {
  ASSERT_EQ(scenes().size(), kSceneNames.size());
  for (std::size_t i = 0; i < kSceneNames.size(); ++i) {
    EXPECT_EQ(scenes()[i].name, kSceneNames[i]);
    EXPECT_EQ(&find_scene(kSceneNames[i]), &scenes()[i]);
    EXPECT_FALSE(scenes()[i].description.empty());
  }
  EXPECT_EQ(input_error([] { find_scene("brick"); }),
            "scene: name: got brick, legal is bricks, curves, text, checkerboard, runway_steep, runway_middle, runway, "
            "runway_low, window, sphere, reflector, magnify, repeat, tessellated, spin");
}

// Analytic against central differences in double, at points off any pixel grid.
TEST(scenes, derivatives_match_finite_differences) {
  constexpr double kStep = 1e-6;
  for (const Scene& scene : all_stills()) {
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
  for (const Scene& scene : all_stills()) {
    const MipLevel base = scene.paint();
    for (const auto& [width, height] : {std::pair{128, 128}, {97, 31}, {1, 1}}) {
      const GBuffer gbuffer = make_gbuffer(scene, width, height);
      ASSERT_EQ(gbuffer.lookups.size(), static_cast<std::size_t>(width * height));
      for (const Lookup& l : gbuffer.lookups) {
        for (const float value : {l.s, l.t, l.dsdx, l.dtdx, l.dsdy, l.dtdy}) {
          ASSERT_TRUE(std::isfinite(value)) << scene.name;
        }
        // Beyond 2^16 texels float32's 24 bits would hold less than the unit's 8 sub-texel bits.
        ASSERT_LT(std::abs(l.s) * static_cast<float>(base.width), 65536.0f) << scene.name;
        ASSERT_LT(std::abs(l.t) * static_cast<float>(base.height), 65536.0f) << scene.name;
      }
    }
  }
}

// A pixel of 3 x 5 covers 3 x 5 of 9 x 25; its centre is the centre of the middle one.
TEST(scenes, resolution_changes_the_pixels_only) {
  for (const Scene& scene : all_stills()) {
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

TEST(scenes, frames_are_stills) {
  const Scene& spin = find_scene("spin");
  ASSERT_EQ(frame_count(spin), 8);
  EXPECT_NE(spin.description.find("sequence of 8 frames"), std::string_view::npos);
  std::set<Projection*> projections;
  for (int i = 0; i < 8; ++i) {
    const Scene still = frame(spin, i);
    EXPECT_EQ(frame_count(still), 1);
    EXPECT_EQ(still.name, spin.name);
    projections.insert(still.project);
  }
  EXPECT_EQ(projections.size(), 8u);
  EXPECT_EQ(frame(spin, 0).project, spin.project);
  for (const Scene& scene : scenes()) EXPECT_EQ(frame_count(scene), scene.name == "spin" ? 8 : 1);
  EXPECT_EQ(input_error([&] { frame(spin, 8); }), "scene spin: frame: got 8, legal is 0 to 7");
  EXPECT_EQ(input_error([] { frame(find_scene("text"), -1); }), "scene text: frame: got -1, legal is 0 to 0");
}

TEST(scenes, size_limits) {
  EXPECT_EQ(input_error([] { make_gbuffer(find_scene("text"), 0, 4); }),
            "scene text: width: got 0, legal is 1 to 16384");
  EXPECT_EQ(input_error([] { make_gbuffer(find_scene("text"), 4, 16385); }),
            "scene text: height: got 16385, legal is 1 to 16384");
}

}  // namespace
}  // namespace feline
