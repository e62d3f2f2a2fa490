// SPDX-License-Identifier: Apache-2.0
#include "testbench/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <fmt/format.h>

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
  const bool read = input.read_image(0, level, 0, channels, type, pixels);
  // Truncated JPEG and TIFF files are filled up and reported as read: the errors are pending only.
  const std::string errors = input.geterror();
  if (!read || !errors.empty()) {
    bad_input(path.string(), "pixels", one_line(errors), "data for every pixel");
  }
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
