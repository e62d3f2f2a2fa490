// SPDX-License-Identifier: Apache-2.0
#include "testbench/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "testbench/error.h"
#include "testbench/image.h"

namespace feline {
namespace {

// Several errors come one a line.
std::string one_line(std::string reason) {
  while (!reason.empty() && reason.back() == '\n') reason.pop_back();
  for (std::size_t end = reason.find('\n'); end != std::string::npos; end = reason.find('\n')) {
    reason.replace(end, 1, "; ");
  }
  return reason.empty() ? "an error without a reason" : reason;
}

void check_side(const std::filesystem::path& path, std::string_view field, int size) {
  if (size < 1 || size > kMaxImageSize) {
    bad_input(path.string(), field, std::to_string(size), fmt::format("1 to {}", kMaxImageSize));
  }
}

// Truncated JPEG and TIFF files are filled up and reported as read: the errors are pending only.
void check_read(OIIO::ImageInput& input, const std::filesystem::path& path, bool read) {
  const std::string errors = input.geterror();
  if (!read || !errors.empty()) {
    bad_input(path.string(), "pixels", one_line(errors), "data for every pixel");
  }
}

}  // namespace

std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& path) {
  OIIO::ImageSpec wish;
  wish.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(path.string(), &wish);
  if (!input) {
    bad_input(path.string(), "open", one_line(OIIO::geterror()), "an image that OpenImageIO reads");
  }
  const OIIO::ImageSpec& spec = input->spec();
  check_side(path, "width", spec.width);
  check_side(path, "height", spec.height);
  if (spec.deep) bad_input(path.string(), "depth", "deep pixels", "a flat image");
  if (spec.depth > 1) bad_input(path.string(), "depth", std::to_string(spec.depth), "1");
  return input;
}

void read_pixels(OIIO::ImageInput& input, const std::filesystem::path& path, int level, int channels,
                 const OIIO::TypeDesc& type, void* pixels) {
  check_read(input, path, input.read_image(0, level, 0, channels, type, pixels));
}

void read_part(OIIO::ImageInput& input, const std::filesystem::path& path, int level, const Part& part, int channels,
               std::vector<std::uint8_t>& texels) {
  texels.resize(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height) *
                static_cast<std::size_t>(channels));
  check_read(input, path, input.seek_subimage(0, level));
  const int x = input.spec().x + part.x;
  const int y = input.spec().y + part.y;
  check_read(input, path,
             input.read_tiles(0, level, x, x + part.width, y, y + part.height, input.spec().z, input.spec().z + 1, 0,
                              channels, OIIO::TypeDesc::UINT8, texels.data()));
}

TexelFormat format_of(int channels) {
  if (channels == 1) return TexelFormat::kR8;
  return channels == 2 ? TexelFormat::kRg8 : TexelFormat::kRgba8;
}

int count_channels(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  const auto& names = spec.channelnames;
  const bool rgba_first =
      spec.nchannels > 4 && names[0] == "R" && names[1] == "G" && names[2] == "B" && names[3] == "A";
  if (spec.nchannels < 1 || (spec.nchannels > 4 && !rgba_first)) {
    bad_input(path.string(), "channels", std::to_string(spec.nchannels), "1 to 4, or R, G, B, A and others");
  }
  return std::min(spec.nchannels, 4);
}

MipLevel convert_channels(const MipLevel& from, int from_channels, int to_channels) {
  const auto from_count = static_cast<std::size_t>(from_channels);
  const auto to_count = static_cast<std::size_t>(to_channels);
  const std::size_t texels = from.texels.size() / from_count;
  MipLevel to{from.width, from.height, {}};
  to.texels.reserve(texels * to_count);
  for (std::size_t texel = 0; texel < texels; ++texel) {
    const std::uint8_t* source = &from.texels[texel * from_count];
    for (std::size_t c = 0; c < to_count; ++c) {
      const std::uint8_t missing = c == 3 ? 255 : from_count == 1 ? source[0] : 0;
      to.texels.push_back(c < from_count ? source[c] : missing);
    }
  }
  return to;
}

bool seek_level(OIIO::ImageInput& input, const std::filesystem::path& path, int width, int height, int level) {
  if (!input.seek_subimage(0, level)) return false;
  const OIIO::ImageSpec& spec = input.spec();
  if (level >= mip_count(width, height)) {
    bad_input(path.string(), fmt::format("level {}", level), fmt::format("{} x {}", spec.width, spec.height),
              "no level after 1 x 1");
  }
  if (spec.width != mip_size(width, level) || spec.height != mip_size(height, level)) {
    bad_input(path.string(), fmt::format("level {}", level), fmt::format("{} x {}", spec.width, spec.height),
              fmt::format("{} x {}", mip_size(width, level), mip_size(height, level)));
  }
  return true;
}

std::vector<std::byte> encode_image(const std::filesystem::path& path, std::string_view kind,
                                    const OIIO::ImageSpec& spec, const void* pixels) {
  const auto fail = [&](const std::string& reason) {
    bad_input(path.string(), "pixels", one_line(reason), fmt::format("an image that {} can hold", kind));
  };
  const std::string name = fmt::format("memory.{}", kind);
  OIIO::Filesystem::IOVecOutput memory;
  auto output = OIIO::ImageOutput::create(name, &memory);
  if (!output) fail(OIIO::geterror());
  if (!output->open(name, spec) || !output->write_image(spec.format, pixels) || !output->close()) {
    fail(output->geterror());
  }
  output.reset();  // some writers flush last here
  const auto* first = reinterpret_cast<const std::byte*>(memory.buffer().data());
  return {first, first + memory.buffer().size()};
}

}  // namespace feline
