// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/images.h"

#include <gtest/gtest.h>

#include <cmath>

#include "testbench/random.h"

namespace feline {
namespace {

MipLevel noise(int width, int height, int channels) {
  SplitMix64 random(3);
  MipLevel level{width, height, {}};
  for (int i = 0; i < width * height * channels; ++i) {
    level.texels.push_back(static_cast<std::uint8_t>(random.below(256)));
  }
  return level;
}

Texture texture_of(const MipLevel& base, TexelFormat format, bool srgb, MipEdge edge = MipEdge::kRepeat) {
  return {format, srgb, build_mip_chain(base, bytes_per_texel(format), MipFilter::kLanczos, srgb, edge)};
}

TEST(measure_images, sizes_of_odd_textures) {
  const Texture texture = texture_of(noise(13, 5, 4), TexelFormat::kRgba8, false);
  const reference::Images images = make_images(texture, {}, MipEdge::kRepeat);
  // 13, 6, 3, 1 by 5, 2, 1.
  EXPECT_EQ(images.rip.columns, 4);
  EXPECT_EQ(images.rip.rows, 3);
  ASSERT_EQ(images.rip.levels.size(), 12U);
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_EQ(images.rip.at(i, j).width, std::max(13 >> i, 1));
      EXPECT_EQ(images.rip.at(i, j).height, std::max(5 >> j, 1));
      EXPECT_EQ(images.rip.at(i, j).texels.size(),
                static_cast<std::size_t>(images.rip.at(i, j).width * images.rip.at(i, j).height));
    }
  }
  for (const reference::MipMap* const map : {&images.lanczos, &images.box}) {
    ASSERT_EQ(map->levels.size(), 4U);
    EXPECT_EQ(map->levels[3].texels.size(), 1U);
    EXPECT_EQ(map->base().texels, images.rip.at(0, 0).texels);
  }
}

// Filtered along one axis after the other, or level by level: but for rounding, the same.
TEST(measure_images, rip_diagonal_is_the_mip_chain) {
  for (const MipEdge edge : {MipEdge::kRepeat, MipEdge::kClamp}) {
    const Texture texture = texture_of(noise(32, 32, 4), TexelFormat::kRgba8, false, edge);
    const reference::Images images = make_images(texture, {}, edge);
    for (int k = 0; k < 6; ++k) {
      const reference::Level& mip = images.lanczos.levels[static_cast<std::size_t>(k)];
      const reference::Level& rip = images.rip.at(k, k);
      ASSERT_EQ(mip.texels.size(), rip.texels.size());
      for (std::size_t i = 0; i < mip.texels.size(); ++i) {
        for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(mip.texels[i][c], rip.texels[i][c], 1.001 / 255) << k;
      }
    }
  }
}

TEST(measure_images, box_levels_are_means) {
  const MipLevel base = noise(8, 8, 1);
  const reference::Images images = make_images(texture_of(base, TexelFormat::kR8, false), {}, MipEdge::kRepeat);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      double sum = 0;
      for (int i = 0; i < 4; ++i) sum += base.texels[static_cast<std::size_t>((2 * y + i / 2) * 8 + 2 * x + i % 2)];
      EXPECT_NEAR(images.box.levels[1].at(x, y)[0], sum / 4 / 255, 0.501 / 255);
    }
  }
}

TEST(measure_images, srgb_codes_are_decoded) {
  MipLevel level{256, 1, {}};
  for (int code = 0; code < 256; ++code) {
    for (int c = 0; c < 4; ++c) level.texels.push_back(static_cast<std::uint8_t>(code));
  }
  const reference::Level decoded = to_reference(level, TexelFormat::kRgba8, true);
  const reference::Level plain = to_reference(level, TexelFormat::kRgba8, false);
  for (int code = 0; code < 256; ++code) {
    const double value = code / 255.0;
    // IEC 61966-2-1: a line up to code 10.
    const double linear = code <= 10 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(decoded.at(code, 0)[c], linear, 6e-8) << code;
    EXPECT_NEAR(decoded.at(code, 0)[3], value, 6e-8);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(plain.at(code, 0)[c], value, 6e-8);
  }
  // Half of the light is code 188, nearly.
  EXPECT_NEAR(decoded.at(188, 0)[0], 0.5, 0.003);
}

TEST(measure_images, missing_channels) {
  const MipLevel level{1, 1, {51, 102}};
  EXPECT_EQ(to_reference(level, TexelFormat::kRg8, false).at(0, 0), (reference::Texel{0.2F, 0.4F, 0, 1}));
  EXPECT_EQ(to_reference({1, 1, {51}}, TexelFormat::kR8, false).at(0, 0), (reference::Texel{0.2F, 0, 0, 1}));
  const reference::Wrapping bordered{Wrap::kClampToBorder, Wrap::kRepeat, {0.5F, 0.25F, 0.125F, 0.75F}};
  const auto border = [&](TexelFormat format) {
    return to_reference(texture_of(noise(2, 2, bytes_per_texel(format)), format, false), bordered).wrapping.border;
  };
  EXPECT_EQ(border(TexelFormat::kR8), (reference::Texel{0.5F, 0, 0, 1}));
  EXPECT_EQ(border(TexelFormat::kRg8), (reference::Texel{0.5F, 0.25F, 0, 1}));
  EXPECT_EQ(border(TexelFormat::kRgba8), bordered.border);
}

}  // namespace
}  // namespace feline
