// SPDX-License-Identifier: Apache-2.0
#include "testbench/image.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/testbench/temp_dir.h"

// OpenImageIO 2.4's PNG reader hands geterror()'s string to libpng, which leaves by longjmp: 31 bytes for each
// truncated PNG, in its own code.
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming): the name that the sanitizer looks for.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:ImageInput::geterror"; }
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

namespace feline {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Any format and type, written by OpenImageIO itself.
template <typename Value>
void write_any(const std::filesystem::path& path, int width, int height, int channels, const std::vector<Value>& values,
               const std::vector<std::string>& names = {}) {
  OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<Value>::value);
  if (!names.empty()) spec.channelnames = names;
  spec.alpha_channel = -1;
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output && output->open(path.string(), spec)) << OIIO::geterror();
  ASSERT_TRUE(output->write_image(spec.format, values.data()) && output->close());
}

Bytes ramp(std::size_t count) {
  Bytes bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(7 * i + i / 5);
  return bytes;
}

TEST(image, channels_choose_the_format) {
  const TempDir dir;
  const std::vector<TexelFormat> formats = {TexelFormat::kR8, TexelFormat::kRg8, TexelFormat::kRgba8,
                                            TexelFormat::kRgba8};
  for (int channels = 1; channels <= 4; ++channels) {
    const auto path = dir / (std::to_string(channels) + ".png");
    const Bytes pixels = ramp(static_cast<std::size_t>(12 * channels));
    write_png(path, 4, 3, channels, pixels);
    const Texture texture = load_texture(path, {.srgb = true});
    EXPECT_EQ(texture.format, formats[static_cast<std::size_t>(channels - 1)]);
    EXPECT_TRUE(texture.srgb);
    ASSERT_EQ(texture.levels.size(), 3u);
    EXPECT_EQ(texture.levels[0].width, 4);
    EXPECT_EQ(texture.levels[0].height, 3);
    if (channels == 3) {
      for (std::size_t i = 0; i < 48; ++i) {
        EXPECT_EQ(texture.levels[0].texels[i], i % 4 == 3 ? 255 : pixels[i / 4 * 3 + i % 4]);
      }
    } else {
      EXPECT_EQ(texture.levels[0].texels, pixels) << channels;
    }
  }
}

TEST(image, format_can_be_asked_for) {
  const TempDir dir;
  write_png(dir / "rgb.png", 1, 1, 3, Bytes{10, 20, 30});
  write_png(dir / "grey.png", 1, 1, 1, Bytes{40});
  const auto texels = [&](const char* name, TexelFormat format) {
    return load_texture(dir / name, {.format = format}).levels[0].texels;
  };
  EXPECT_EQ(texels("rgb.png", TexelFormat::kR8), (Bytes{10}));
  EXPECT_EQ(texels("rgb.png", TexelFormat::kRg8), (Bytes{10, 20}));
  EXPECT_EQ(texels("grey.png", TexelFormat::kRg8), (Bytes{40, 40}));
  EXPECT_EQ(texels("grey.png", TexelFormat::kRgba8), (Bytes{40, 40, 40, 255}));
}

TEST(image, wider_types_become_8_bit) {
  const TempDir dir;
  write_any<std::uint16_t>(dir / "w.png", 3, 1, 1, {0, 257 * 99, 65535});
  EXPECT_EQ(load_texture(dir / "w.png").levels[0].texels, (Bytes{0, 99, 255}));
  write_any<float>(dir / "f.exr", 4, 1, 1, {-1.0f, 0.5f, 1.0f, 7.0f});
  EXPECT_EQ(load_texture(dir / "f.exr").levels[0].texels, (Bytes{0, 128, 255, 255}));
}

TEST(image, alpha_is_unassociated_both_ways) {
  const TempDir dir;
  const Bytes pixels = {200, 100, 50, 10, 255, 255, 255, 0};
  write_png(dir / "a.png", 2, 1, 4, pixels);
  EXPECT_EQ(load_texture(dir / "a.png").levels[0].texels, pixels);
}

TEST(image, tx_brings_its_own_levels) {
  const TempDir dir;
  const Bytes grey = ramp(10 * 6);
  write_any<std::uint8_t>(dir / "a.tif", 10, 6, 1, grey);
  OIIO::ImageSpec config;
  config.attribute("maketx:filtername", "box");
  ASSERT_TRUE(OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, (dir / "a.tif").string(),
                                               (dir / "a.tx").string(), config));
  const Texture texture = load_texture(dir / "a.tx");
  ASSERT_EQ(texture.levels.size(), 4u);
  EXPECT_EQ(texture.levels[0].texels, grey);
  for (int k = 0; k < 4; ++k) {
    OIIO::ImageBuf level((dir / "a.tx").string(), 0, k);
    Bytes expected(texture.levels[static_cast<std::size_t>(k)].texels.size());
    ASSERT_TRUE(level.get_pixels(level.roi(), OIIO::TypeDesc::UINT8, expected.data()));
    EXPECT_EQ(texture.levels[static_cast<std::size_t>(k)].texels, expected) << k;
  }
}

// A tiled file of one channel with levels of these sides, of which the first is the spec's.
void write_levels(const std::string& path, OIIO::ImageSpec spec, std::initializer_list<int> sides,
                  OIIO::ImageOutput::OpenMode append) {
  spec.attribute("textureformat", "Plain Texture");
  const auto output = OIIO::ImageOutput::create(path);
  auto mode = OIIO::ImageOutput::Create;
  for (const int side : sides) {
    spec.width = spec.height = spec.full_width = spec.full_height = side;
    ASSERT_TRUE(output->open(path, spec, mode)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, ramp(25).data()));
    mode = append;
  }
  ASSERT_TRUE(output->close());
}

// OpenEXR may round sizes up.
TEST(image, levels_of_other_sizes) {
  const TempDir dir;
  const std::string path = (dir / "up.exr").string();
  OIIO::ImageSpec spec(5, 5, 1, OIIO::TypeDesc::HALF);
  spec.tile_width = spec.tile_height = 8;
  spec.attribute("openexr:levelmode", 1);
  spec.attribute("openexr:roundingmode", 1);
  write_levels(path, spec, {5, 3, 2, 1}, OIIO::ImageOutput::AppendMIPLevel);
  EXPECT_EQ(input_error([&] { load_texture(path); }), path + ": level 1: got 3 x 3, legal is 2 x 2");
}

TEST(image, levels_after_the_last) {
  const TempDir dir;
  const std::string path = (dir / "long.tif").string();
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeDesc::UINT8);
  spec.tile_width = spec.tile_height = 16;
  write_levels(path, spec, {2, 1, 1}, OIIO::ImageOutput::AppendSubimage);
  EXPECT_EQ(input_error([&] { load_texture(path); }), path + ": level 2: got 1 x 1, legal is no level after 1 x 1");
}

TEST(image, size_limits) {
  const TempDir dir;
  write_png(dir / "widest.png", kMaxImageSize, 1, 1, ramp(kMaxImageSize));
  EXPECT_EQ(load_texture(dir / "widest.png").levels.size(), 15u);
  write_any(dir / "w.png", kMaxImageSize + 1, 1, 1, ramp(kMaxImageSize + 1));
  EXPECT_EQ(input_error([&] { load_texture(dir / "w.png"); }),
            (dir / "w.png").string() + ": width: got 16385, legal is 1 to 16384");
  write_any(dir / "h.png", 1, kMaxImageSize + 1, 1, ramp(kMaxImageSize + 1));
  EXPECT_EQ(input_error([&] { load_texture(dir / "h.png"); }),
            (dir / "h.png").string() + ": height: got 16385, legal is 1 to 16384");
}

TEST(image, more_than_four_channels) {
  const TempDir dir;
  write_any<float>(dir / "rgba.exr", 1, 1, 5, {0.2f, 0.4f, 0.6f, 1.0f, 9.0f}, {"R", "G", "B", "A", "Z"});
  EXPECT_EQ(load_texture(dir / "rgba.exr").levels[0].texels, (Bytes{51, 102, 153, 255}));
  write_any(dir / "many.exr", 1, 1, 5, ramp(5), {"a", "b", "c", "d", "e"});
  EXPECT_EQ(input_error([&] { load_texture(dir / "many.exr"); }),
            (dir / "many.exr").string() + ": channels: got 5, legal is 1 to 4, or R, G, B, A and others");
}

TEST(image, missing_and_foreign_files) {
  const TempDir dir;
  const std::string missing = input_error([&] { load_texture(dir / "none.png"); });
  EXPECT_EQ(missing.find((dir / "none.png").string() + ": open: got "), 0u) << missing;
  write_bytes(dir / "text.png", "this is not an image");
  const std::string foreign = input_error([&] { load_texture(dir / "text.png"); });
  EXPECT_EQ(foreign.find((dir / "text.png").string() + ": open: got "), 0u) << foreign;
  write_bytes(dir / "empty.png", "");
  const std::string empty = input_error([&] { load_texture(dir / "empty.png"); });
  EXPECT_EQ(empty.find((dir / "empty.png").string() + ": open: got "), 0u) << empty;
  const std::string folder = input_error([&] { load_texture(dir / ""); });
  EXPECT_NE(folder.find(": open: got "), std::string::npos) << folder;
}

TEST(image, truncated_data) {
  const TempDir dir;
  for (const char* kind : {"png", "tif", "exr", "jpg", "tga", "bmp", "webp"}) {
    const auto path = dir / ("cut." + std::string(kind));
    write_any(path, 64, 64, 3, ramp(64 * 64 * 3));
    const std::string whole = read_bytes(path);
    write_bytes(path, whole.substr(0, whole.size() / 2));
    const std::string message = input_error([&] { load_texture(path); });
    EXPECT_EQ(message.find(path.string() + ": "), 0u) << kind << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(image, png_bytes_are_deterministic_and_anonymous) {
  const TempDir dir;
  write_png(dir / "a.png", 8, 8, 3, ramp(192));
  write_png(dir / "b.png", 8, 8, 3, ramp(192));
  const std::string bytes = read_bytes(dir / "a.png");
  EXPECT_EQ(bytes, read_bytes(dir / "b.png"));
  for (const char* mark : {"tIME", "eXIf", "Software", "OpenImageIO", "DateTime", "HostComputer"}) {
    EXPECT_EQ(bytes.find(mark), std::string::npos) << mark;
  }
}

TEST(image, png_16_bit_is_lossless) {
  const TempDir dir;
  const std::vector<std::uint16_t> pixels = {0, 1, 255, 256, 32768, 65535};
  write_png(dir / "a.png", 3, 1, 2, pixels);
  const auto input = OIIO::ImageInput::open((dir / "a.png").string());
  ASSERT_TRUE(input);
  EXPECT_EQ(input->spec().format, OIIO::TypeDesc::UINT16);
  std::vector<std::uint16_t> read(6);
  OIIO::ImageSpec wish;
  wish.attribute("oiio:UnassociatedAlpha", 1);
  const auto plain = OIIO::ImageInput::open((dir / "a.png").string(), &wish);
  ASSERT_TRUE(plain->read_image(0, 0, 0, 2, OIIO::TypeDesc::UINT16, read.data()));
  EXPECT_EQ(read, pixels);
}

TEST(image, png_that_cannot_be_written) {
  const TempDir dir;
  EXPECT_EQ(input_error([] { write_png("/dev/full", 1, 1, 1, Bytes{0}); }),
            "/dev/full: write: got No space left on device, legal is a writable file on a disk with room");
  const std::string message = input_error([&] { write_png(dir / "no/a.png", 1, 1, 1, Bytes{0}); });
  EXPECT_EQ(message.find((dir / "no/a.png").string() + ": open: got No such file"), 0u) << message;
  EXPECT_THROW(write_png(dir / "a.png", 2, 1, 1, Bytes{0}), std::invalid_argument);
  EXPECT_EQ(dir.file_count(), 0);
}

}  // namespace
}  // namespace feline
