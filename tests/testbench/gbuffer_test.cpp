// SPDX-License-Identifier: Apache-2.0
#include "testbench/gbuffer.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

using Names = std::vector<std::string>;
using Words = std::array<std::uint32_t, 6>;

const Names kNames = {"s", "t", "dsdx", "dtdx", "dsdy", "dtdy"};

// An OpenEXR file of any channels, written by OpenImageIO itself.
template <typename Value>
void write_exr(const std::filesystem::path& path, int width, int height, const Names& names,
               const std::vector<Value>& values, const OIIO::TypeDesc& stored) {
  OIIO::ImageSpec spec(width, height, static_cast<int>(names.size()), stored);
  spec.channelnames = names;
  const auto output = OIIO::ImageOutput::create("exr");
  ASSERT_TRUE(output->open(path.string(), spec)) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<Value>::value, values.data()));
  ASSERT_TRUE(output->close());
}

GBuffer random_gbuffer(int width, int height) {
  std::mt19937 random(5);
  GBuffer gbuffer{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    Words words;
    for (std::uint32_t& word : words) word = static_cast<std::uint32_t>(random());
    gbuffer.lookups.push_back(std::bit_cast<Lookup>(words));
  }
  return gbuffer;
}

GBuffer plain_gbuffer(int width, int height) {
  return {width, height,
          std::vector<Lookup>(static_cast<std::size_t>(width * height), Lookup{0.5f, 0.25f, 0.1f, 0.2f, 0.3f, 0.4f})};
}

void expect_same_bits(const GBuffer& a, const GBuffer& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.lookups.size(), b.lookups.size());
  for (std::size_t i = 0; i < a.lookups.size(); ++i) {
    ASSERT_EQ(std::bit_cast<Words>(a.lookups[i]), std::bit_cast<Words>(b.lookups[i])) << i;
  }
}

// Random words hold every float32 class: NaN payloads, infinities, denormals, both zeros.
TEST(gbuffer, round_trip_keeps_every_bit) {
  const TempDir dir;
  GBuffer gbuffer = random_gbuffer(67, 41);
  gbuffer.lookups[0] = {-0.0f,
                        0.0f,
                        std::numeric_limits<float>::infinity(),
                        std::numeric_limits<float>::denorm_min(),
                        std::bit_cast<float>(0x7fa00001u),
                        std::bit_cast<float>(0xffc12345u)};
  write_gbuffer(dir / "g.exr", gbuffer);
  expect_same_bits(read_gbuffer(dir / "g.exr", {.allow_non_finite = true}), gbuffer);
  EXPECT_EQ(dir.file_count(), 1);
}

TEST(gbuffer, bytes_are_deterministic_and_anonymous) {
  const TempDir dir;
  write_gbuffer(dir / "a.exr", random_gbuffer(33, 20));
  write_gbuffer(dir / "b.exr", random_gbuffer(33, 20));
  const std::string bytes = read_bytes(dir / "a.exr");
  EXPECT_EQ(bytes, read_bytes(dir / "b.exr"));
  for (const char* field : {"Software", "owner", "HostComputer", "comments"}) {
    EXPECT_EQ(bytes.find(field), std::string::npos) << field;
  }
  const auto input = OIIO::ImageInput::open((dir / "a.exr").string());
  EXPECT_EQ(input->spec().get_string_attribute("DateTime"), "");
}

TEST(gbuffer, any_order_and_extra_channels) {
  const TempDir dir;
  write_exr<float>(dir / "g.exr", 2, 1, {"dtdy", "R", "s", "dsdy", "t", "Z", "dtdx", "dsdx"},
                   {6, -1, 1, 5, 2, -1, 4, 3, 16, -1, 11, 15, 12, -1, 14, 13}, OIIO::TypeDesc::FLOAT);
  expect_same_bits(read_gbuffer(dir / "g.exr"), {2, 1, {{1, 2, 3, 4, 5, 6}, {11, 12, 13, 14, 15, 16}}});
}

TEST(gbuffer, half_is_widened) {
  const TempDir dir;
  write_exr<float>(dir / "g.exr", 1, 1, kNames, {0.5f, -1.25f, 0x1p-24f, 65504.0f, 0.0f, 3.0f}, OIIO::TypeDesc::HALF);
  expect_same_bits(read_gbuffer(dir / "g.exr"), {1, 1, {{0.5f, -1.25f, 0x1p-24f, 65504.0f, 0.0f, 3.0f}}});
}

TEST(gbuffer, missing_channels_are_listed) {
  const TempDir dir;
  write_exr<float>(dir / "g.exr", 1, 1, {"s", "T", "dsdx", "dsdy", "dtdy"}, {0, 0, 0, 0, 0}, OIIO::TypeDesc::FLOAT);
  EXPECT_EQ(input_error([&] { read_gbuffer(dir / "g.exr"); }),
            (dir / "g.exr").string() + ": channels: got a file without t, dtdx, legal is s, t, dsdx, dtdx, dsdy, dtdy");
}

TEST(gbuffer, integer_channel) {
  const TempDir dir;
  write_exr<std::uint32_t>(dir / "g.exr", 1, 1, kNames, {1, 2, 3, 4, 5, 6}, OIIO::TypeDesc::UINT32);
  EXPECT_EQ(input_error([&] { read_gbuffer(dir / "g.exr"); }),
            (dir / "g.exr").string() + ": type of channel s: got uint, legal is float or half");
}

TEST(gbuffer, non_finite_pixels_are_located) {
  const TempDir dir;
  const auto message = [&](float Lookup::*member, float value) {
    GBuffer gbuffer = plain_gbuffer(4, 3);
    gbuffer.lookups[2 * 4 + 1].*member = value;
    write_gbuffer(dir / "g.exr", gbuffer);
    return input_error([&] { read_gbuffer(dir / "g.exr"); });
  };
  const std::string file = (dir / "g.exr").string();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(message(&Lookup::dtdx, std::numeric_limits<float>::quiet_NaN()),
            file + ": dtdx at pixel (1, 2): got nan, legal is a finite number");
  EXPECT_EQ(message(&Lookup::s, -kInfinity), file + ": s at pixel (1, 2): got -inf, legal is a finite number");
}

TEST(gbuffer, size_limits) {
  const TempDir dir;
  write_gbuffer(dir / "wide.exr", plain_gbuffer(16384, 1));
  EXPECT_EQ(read_gbuffer(dir / "wide.exr").width, 16384);
  write_gbuffer(dir / "w.exr", plain_gbuffer(16385, 1));
  EXPECT_EQ(input_error([&] { read_gbuffer(dir / "w.exr"); }),
            (dir / "w.exr").string() + ": width: got 16385, legal is 1 to 16384");
  write_gbuffer(dir / "h.exr", plain_gbuffer(1, 16385));
  EXPECT_EQ(input_error([&] { read_gbuffer(dir / "h.exr"); }),
            (dir / "h.exr").string() + ": height: got 16385, legal is 1 to 16384");
}

TEST(gbuffer, missing_foreign_and_truncated_files) {
  const TempDir dir;
  const auto starts_with = [](const std::string& message, const std::string& start) {
    EXPECT_EQ(message.find(start), 0u) << message;
  };
  starts_with(input_error([&] { read_gbuffer(dir / "none.exr"); }), (dir / "none.exr").string() + ": open: got ");
  write_bytes(dir / "text.exr", "s,t,dsdx,dtdx,dsdy,dtdy");
  starts_with(input_error([&] { read_gbuffer(dir / "text.exr"); }), (dir / "text.exr").string() + ": open: got ");
  write_gbuffer(dir / "cut.exr", random_gbuffer(64, 64));
  const std::string whole = read_bytes(dir / "cut.exr");
  write_bytes(dir / "cut.exr", whole.substr(0, whole.size() / 2));
  starts_with(input_error([&] { read_gbuffer(dir / "cut.exr", {.allow_non_finite = true}); }),
              (dir / "cut.exr").string() + ": pixels: got ");
}

TEST(gbuffer, output_that_cannot_be_written) {
  const TempDir dir;
  EXPECT_EQ(input_error([] { write_gbuffer("/dev/full", plain_gbuffer(2, 2)); }),
            "/dev/full: write: got No space left on device, legal is a writable file on a disk with room");
  EXPECT_THROW(write_gbuffer(dir / "g.exr", {2, 2, {}}), std::invalid_argument);
  EXPECT_EQ(dir.file_count(), 0);
}

}  // namespace
}  // namespace feline
