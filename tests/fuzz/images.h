// SPDX-License-Identifier: Apache-2.0
// What the targets share that read image files.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstring>

#include "testbench/image.h"
#include "testbench/image_io.h"
#include "tests/fuzz/fuzz.h"

namespace feline::fuzz {

// OpenImageIO in this thread alone, and of its readers the one of a file's extension.
inline void limit_openimageio() {
  static const bool done =
      OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1) && OIIO::attribute("try_all_readers", 0);
  require(done, "OpenImageIO has these attributes");
}

// Whether the attributes of an OpenEXR file are within it; other files have none. OpenEXR 3.1.5 fills a text with as
// many zeros as its size says, up to 2 GB, before it finds the end of the file: "libFuzzer: out-of-memory" in
// Imf_3_1::TypedAttribute<std::string>::readValueFrom.
inline bool has_its_attributes(std::string_view file) {
  constexpr std::string_view kMagic{"\x76\x2f\x31\x01", 4};
  constexpr std::size_t kFirst = 8;  // after magic number and version
  if (!file.starts_with(kMagic) || file.size() < kFirst) return true;
  const bool has_parts = (file[5] & 0x10) != 0;
  for (std::size_t at = kFirst; at < file.size();) {
    const std::size_t name_end = file.find('\0', at);
    if (name_end == at) {
      if (!has_parts) return true;
      ++at;
      continue;
    }
    const std::size_t type_end = name_end == file.npos ? name_end : file.find('\0', name_end + 1);
    std::uint32_t size = 0;
    if (type_end == file.npos || file.size() - type_end <= sizeof size) return true;
    std::memcpy(&size, file.data() + type_end + 1, sizeof size);
    at = type_end + 1 + sizeof size;
    if (size > file.size() - at) return false;
    at += size;
  }
  return true;
}

// A file that is not too much for a test. Larger ones are legal, and take the time and the gigabytes that they take.
// Throws InputError as open_image does.
inline bool is_small(const std::filesystem::path& path, std::string_view bytes) {
  constexpr std::int64_t kMostValues = 1 << 20;
  if (!has_its_attributes(bytes)) return false;
  const auto input = open_image(path);
  const OIIO::ImageSpec& spec = input->spec();
  require(spec.width >= 1 && spec.width <= kMaxImageSize && spec.height >= 1 && spec.height <= kMaxImageSize,
          "open_image: sides of 1 to kMaxImageSize");
  require(!spec.deep && spec.depth <= 1, "open_image: flat");
  return std::int64_t{spec.width} * spec.height <= kMostValues / std::max(spec.nchannels, 1);
}

}  // namespace feline::fuzz
