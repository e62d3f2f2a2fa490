// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/float_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "testbench/image.h"
#include "testbench/measure/detail.h"
#include "testbench/picture.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

// (column, row, 0, 1), so that each pixel says where it was.
FloatPicture numbered(int width, int height) {
  FloatPicture picture{width, height, {}};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      picture.pixels.push_back({static_cast<float>(column), static_cast<float>(row), 0, 1});
    }
  }
  return picture;
}

// The stored bytes of a PNG file, by the reader of textures.
MipLevel decoded(const std::vector<std::byte>& png, TexelFormat format) {
  const TempDir dir;
  write_bytes(dir / "a.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  const Texture texture = load_texture(dir / "a.png");
  EXPECT_EQ(texture.format, format);
  return texture.levels.front();
}

TEST(measure_float_picture, every_code_comes_back) {
  FloatPicture picture{256, 1, {}};
  FloatPicture plain{256, 1, {}};
  for (int code = 0; code < 256; ++code) {
    const double value = code / 255.0;
    const double linear = code <= 10 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    const auto real = static_cast<float>(linear);
    const auto alpha = static_cast<float>(value);
    picture.pixels.push_back({real, real, real, alpha});
    plain.pixels.push_back({alpha, alpha, alpha, alpha});
  }
  const auto srgb = to_bytes(picture, true, 4);
  const auto linear = to_bytes(plain, false, 3);
  ASSERT_EQ(srgb.size(), 1024U);
  ASSERT_EQ(linear.size(), 768U);
  for (std::size_t i = 0; i < srgb.size(); ++i) EXPECT_EQ(srgb[i], i / 4);
  for (std::size_t i = 0; i < linear.size(); ++i) EXPECT_EQ(linear[i], i / 3);
}

TEST(measure_float_picture, nearest_and_clamped) {
  const float code = 1.0F / 255;
  const FloatPicture picture{2, 1, {{-1, 2, 0.499F * code, 0.501F * code}, {1.499F * code, 1.501F * code, 1, 0}}};
  EXPECT_EQ(to_bytes(picture, false, 4), (std::vector<std::uint8_t>{0, 255, 0, 1, 1, 2, 255, 0}));
}

TEST(measure_float_picture, files_hold_the_codes) {
  const FloatPicture picture{2, 2, {{0, 0.2F, 1, 1}, {1, 0, 0, 1}, {0.5F, 0.5F, 0.5F, 1}, {0, 0, 0, 1}}};
  const MipLevel colours = decoded(picture_png(picture, false, 4), TexelFormat::kRgba8);
  EXPECT_EQ(colours.texels,
            (std::vector<std::uint8_t>{0, 51, 255, 255, 255, 0, 0, 255, 128, 128, 128, 255, 0, 0, 0, 255}));
  EXPECT_EQ(decoded(picture_png(picture, true, 4), TexelFormat::kRgba8).texels[8], 188);
  const MipLevel grey = decoded(picture_png(picture, false, 1), TexelFormat::kR8);
  EXPECT_EQ(grey.texels, (std::vector<std::uint8_t>{0, 255, 128, 0}));
  EXPECT_EQ(decoded(detail_png(picture, {1, 0, 1}, false, 1), TexelFormat::kR8).texels, std::vector<std::uint8_t>{255});
  const TempDir dir;
  OutputFiles outputs;
  write_picture(outputs, dir / "a.png", {1, 1, {{0.5F, 0, 1, 0.5F}}}, true);
  outputs.commit();
  EXPECT_EQ(load_texture(dir / "a.png").levels[0].texels, (std::vector<std::uint8_t>{188, 0, 255, 128}));
}

TEST(measure_float_picture, crops_end_at_the_edges) {
  const FloatPicture picture = numbered(10, 6);
  const FloatPicture inner = crop(picture, {3, 2, 4});
  EXPECT_EQ(inner.width, 4);
  EXPECT_EQ(inner.height, 4);
  EXPECT_EQ(inner.at(0, 0)[0], 3);
  EXPECT_EQ(inner.at(3, 1)[0], 6);
  EXPECT_EQ(inner.at(3, 1)[1], 3);
  const FloatPicture corner = crop(picture, {8, 3, 4});
  EXPECT_EQ(corner.width, 2);
  EXPECT_EQ(corner.height, 3);
  EXPECT_EQ(corner.at(1, 2), picture.at(9, 5));
  EXPECT_EQ(crop(picture, {0, 0, 96}).pixels, picture.pixels);
}

TEST(measure_float_picture, difference_is_around_grey) {
  const FloatPicture a{2, 1, {{0.5F, 0.25F, 0, 1}, {0, 0, 0, 0}}};
  const FloatPicture b{2, 1, {{0.25F, 0.5F, 0, 0.5F}, {0, 0, 0, 1}}};
  const FloatPicture apart = difference(a, b, 2);
  EXPECT_EQ(apart.at(0, 0), (std::array<float, 4>{1, 0, 0.5F, 1}));
  EXPECT_EQ(apart.at(1, 0), (std::array<float, 4>{0.5F, 0.5F, 0.5F, 1}));
}

TEST(measure_detail, finds_what_was_planted) {
  const FloatPicture plain{64, 48, std::vector<std::array<float, 4>>(std::size_t{64} * 48, {0.5F, 0.5F, 0.5F, 1})};
  for (const auto& [left, top] : {std::pair(0, 0), std::pair(40, 24), std::pair(56, 40), std::pair(8, 40)}) {
    FloatPicture planted = plain;
    for (int row = top; row < top + 8; ++row) {
      for (int column = left; column < left + 8; ++column) {
        planted.pixels[static_cast<std::size_t>(row * 64 + column)][1] = 0.6F;
      }
    }
    planted.pixels[20 * 64 + 20][0] = 1;  // less in all
    for (const Detail& found : {find_detail(planted, plain, 16), find_detail(plain, planted, 16)}) {
      EXPECT_EQ(found.size, 16);
      EXPECT_LE(found.left, left);
      EXPECT_GE(found.left + 16, left + 8);
      EXPECT_LE(found.top, top);
      EXPECT_GE(found.top + 16, top + 8);
    }
  }
  const Detail whole = find_detail(plain, plain, 96);
  EXPECT_EQ(whole.left, 0);
  EXPECT_EQ(whole.top, 0);
  EXPECT_EQ(find_detail(plain, plain, 1).size, 1);
}

TEST(measure_detail, probes_have_their_colours) {
  const std::vector<float> probes{1, 2, 16, 8, 4, 1};
  const MipLevel level = decoded(probes_png(probes, 3, {1, 0, 96}), TexelFormat::kRgba8);
  EXPECT_EQ(level.width, 2);
  EXPECT_EQ(level.height, 2);
  const auto counts = {2, 16, 4, 1};
  std::size_t at = 0;
  for (const int count : counts) {
    for (const int channel : probe_colour(count)) EXPECT_EQ(level.texels[at++], channel);
    ++at;
  }
}

}  // namespace
}  // namespace feline
