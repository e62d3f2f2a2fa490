// SPDX-License-Identifier: Apache-2.0
#include "testbench/mip_chain.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

namespace feline {
namespace {

using Texels = std::vector<std::uint8_t>;

constexpr std::array kFilters = {MipFilter::kLanczos, MipFilter::kBox};
constexpr std::array kEdges = {MipEdge::kClamp, MipEdge::kRepeat};
constexpr std::array<std::pair<int, int>, 9> kChainSizes = {
    {{1, 1}, {2, 1}, {1, 17}, {5, 1}, {3, 3}, {16, 16}, {37, 10}, {60, 84}, {255, 2}}};

MipLevel random_level(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  MipLevel level{width, height, Texels(static_cast<std::size_t>(width * height * channels))};
  for (std::uint8_t& texel : level.texels) texel = static_cast<std::uint8_t>(random() >> 24);
  return level;
}

TEST(mip_chain, sizes_go_down_to_one) {
  for (const auto& [width, height] : kChainSizes) {
    for (const MipFilter filter : kFilters) {
      for (const MipEdge edge : kEdges) {
        const auto levels = build_mip_chain(random_level(width, height, 2, 1), 2, filter, false, edge);
        const int count = 1 + static_cast<int>(std::log2(std::max(width, height)));
        ASSERT_EQ(levels.size(), static_cast<std::size_t>(count)) << width << " x " << height;
        EXPECT_EQ(mip_count(width, height), count);
        for (int k = 0; k < count; ++k) {
          const MipLevel& level = levels[static_cast<std::size_t>(k)];
          EXPECT_EQ(level.width, std::max(1, width >> k));
          EXPECT_EQ(level.height, std::max(1, height >> k));
          EXPECT_EQ(level.texels.size(), static_cast<std::size_t>(level.width * level.height * 2));
        }
      }
    }
  }
}

TEST(mip_chain, level_zero_is_untouched) {
  const MipLevel base = random_level(37, 10, 4, 2);
  EXPECT_EQ(build_mip_chain(base, 4, MipFilter::kLanczos, true).front().texels, base.texels);
}

// Every value, every format, both filters, both edges, linear and sRGB.
TEST(mip_chain, constant_stays_constant) {
  for (const auto& [width, height] : kChainSizes) {
    for (int value = 0; value < 256; value += width == 37 ? 1 : 51) {
      for (const MipFilter filter : kFilters) {
        for (const MipEdge edge : kEdges) {
          for (const bool srgb : {false, true}) {
            const auto texel = static_cast<std::uint8_t>(value);
            const MipLevel base{width, height, Texels(static_cast<std::size_t>(width * height), texel)};
            for (const MipLevel& level : build_mip_chain(base, 1, filter, srgb, edge)) {
              const auto equal = std::ranges::count(level.texels, texel);
              ASSERT_EQ(equal, std::ssize(level.texels)) << value << " at " << level.width;
            }
          }
        }
      }
    }
  }
}

TEST(mip_chain, box_is_the_area_average) {
  // 4 x 2, then 5 x 1: whole texels, then the middle texel shared by halves.
  const MipLevel even{4, 2, {0, 10, 20, 30, 40, 50, 60, 71}};
  EXPECT_EQ(build_mip_chain(even, 1, MipFilter::kBox, false)[1].texels, (Texels{25, 45}));
  const MipLevel odd{5, 1, {10, 20, 40, 60, 100}};
  EXPECT_EQ(build_mip_chain(odd, 1, MipFilter::kBox, false)[1].texels, (Texels{20, 72}));
}

TEST(mip_chain, srgb_is_averaged_in_light) {
  // Half of the light of white is sRGB 188; alpha is linear and becomes 128.
  const MipLevel base{2, 1, {0, 0, 255, 0, 255, 0, 255, 255}};
  EXPECT_EQ(build_mip_chain(base, 4, MipFilter::kBox, true)[1].texels, (Texels{188, 0, 255, 128}));
  EXPECT_EQ(build_mip_chain(base, 4, MipFilter::kBox, false)[1].texels, (Texels{128, 0, 255, 128}));
}

// The weights of a halving by radius 3, derived here from sinc: an impulse shows them, doubled.
TEST(mip_chain, lanczos_has_radius_three_in_the_destination) {
  MipLevel base{64, 1, Texels(64, 100)};
  base.texels[31] = 200;
  const auto level = build_mip_chain(base, 1, MipFilter::kLanczos, false)[1];
  const auto weight = [](double x) {
    const double a = std::acos(-1.0) * x;
    return std::abs(x) >= 3 ? 0.0 : 3 * std::sin(a) * std::sin(a / 3) / (a * a);
  };
  double sum = 0;
  for (int tap = -6; tap < 6; ++tap) sum += weight((tap + 0.5) / 2);
  for (int x = 0; x < 32; ++x) {
    const double expected = 100 + 100 * weight((31.5 - (2 * x + 1)) / 2) / sum;
    EXPECT_EQ(level.texels[static_cast<std::size_t>(x)], std::lround(expected)) << x;
  }
}

// Texel 0 lit: its light reaches the last texels of a periodic level, and not of a clamped one.
TEST(mip_chain, repeat_has_no_seam) {
  MipLevel base{32, 32, Texels(1024, 0)};
  for (std::size_t y = 0; y < 32; ++y) base.texels[y * 32] = 255;
  const auto repeat = build_mip_chain(base, 1, MipFilter::kLanczos, false, MipEdge::kRepeat);
  const auto clamp = build_mip_chain(base, 1, MipFilter::kLanczos, false, MipEdge::kClamp);
  EXPECT_GT(repeat[1].texels[15], 0);
  EXPECT_EQ(clamp[1].texels[15], 0);
}

TEST(mip_chain, repeat_commutes_with_shifting) {
  const MipLevel base = random_level(16, 8, 1, 4);
  MipLevel shifted = base;
  for (std::size_t y = 0; y < 8; ++y) {
    for (std::size_t x = 0; x < 16; ++x) {
      shifted.texels[y * 16 + x] = base.texels[(y + 2) % 8 * 16 + (x + 4) % 16];
    }
  }
  for (const MipFilter filter : kFilters) {
    const auto a = build_mip_chain(base, 1, filter, false, MipEdge::kRepeat)[1].texels;
    const auto b = build_mip_chain(shifted, 1, filter, false, MipEdge::kRepeat)[1].texels;
    for (std::size_t y = 0; y < 4; ++y) {
      for (std::size_t x = 0; x < 8; ++x) {
        EXPECT_NEAR(b[y * 8 + x], a[(y + 1) % 4 * 8 + (x + 2) % 8], 1);
      }
    }
  }
}

// OpenImageIO's own kernel, independent of ours and good to 9e-4, gives the same picture.
TEST(mip_chain, agrees_with_openimageio) {
  const MipLevel base = random_level(64, 48, 4, 3);
  OIIO::ImageBuf source(OIIO::ImageSpec(64, 48, 4, OIIO::TypeDesc::UINT8),
                        const_cast<std::uint8_t*>(base.texels.data()));
  Texels expected(32 * 24 * 4);
  OIIO::ImageBuf target(OIIO::ImageSpec(32, 24, 4, OIIO::TypeDesc::UINT8), expected.data());
  ASSERT_TRUE(OIIO::ImageBufAlgo::resize(target, source, "lanczos3"));
  const auto level = build_mip_chain(base, 4, MipFilter::kLanczos, false)[1];
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(level.texels[i], expected[i], 2);
}

TEST(mip_chain, wrong_texel_count) {
  const MipLevel base{4, 4, Texels(15)};
  EXPECT_THROW(build_mip_chain(base, 1, MipFilter::kBox, false), std::invalid_argument);
}

}  // namespace
}  // namespace feline
