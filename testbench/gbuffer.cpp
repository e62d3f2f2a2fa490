// SPDX-License-Identifier: Apache-2.0
#include "testbench/gbuffer.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/image_io.h"

namespace feline {
namespace {

struct Channel {
  const char* name;
  float Lookup::*member;
};

constexpr std::array<Channel, 6> kChannels = {{{"s", &Lookup::s},
                                               {"t", &Lookup::t},
                                               {"dsdx", &Lookup::dsdx},
                                               {"dtdx", &Lookup::dtdx},
                                               {"dsdy", &Lookup::dsdy},
                                               {"dtdy", &Lookup::dtdy}}};

constexpr std::string_view kLegalChannels = "s, t, dsdx, dtdx, dsdy, dtdy";

void check_channels(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  std::string missing;
  for (const Channel& channel : kChannels) {
    const int index = spec.channelindex(channel.name);
    if (index < 0) {
      missing += fmt::format("{}{}", missing.empty() ? "" : ", ", channel.name);
      continue;
    }
    // An integer channel would be read as a fraction of its largest value.
    const OIIO::TypeDesc type = spec.channelformat(index);
    if (type != OIIO::TypeDesc::FLOAT && type != OIIO::TypeDesc::HALF) {
      bad_input(path.string(), fmt::format("type of channel {}", channel.name), type.c_str(), "float or half");
    }
  }
  if (!missing.empty()) {
    bad_input(path.string(), "channels", fmt::format("a file without {}", missing), kLegalChannels);
  }
}

void check_finite(const std::filesystem::path& path, const GBuffer& gbuffer) {
  const auto width = static_cast<std::size_t>(gbuffer.width);
  for (std::size_t pixel = 0; pixel < gbuffer.lookups.size(); ++pixel) {
    for (const Channel& channel : kChannels) {
      const float value = gbuffer.lookups[pixel].*channel.member;
      if (std::isfinite(value)) continue;
      bad_input(path.string(), fmt::format("{} at pixel ({}, {})", channel.name, pixel % width, pixel / width),
                fmt::format("{}", value), "a finite number");
    }
  }
}

}  // namespace

GBuffer read_gbuffer(const std::filesystem::path& path, const GBufferOptions& options) {
  const auto input = open_image(path);
  const OIIO::ImageSpec spec = input->spec();
  check_channels(path, spec);
  const auto pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
  const auto stride = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> values(pixels * stride);
  read_pixels(*input, path, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data());

  GBuffer gbuffer{spec.width, spec.height, std::vector<Lookup>(pixels)};
  for (const Channel& channel : kChannels) {
    const auto offset = static_cast<std::size_t>(spec.channelindex(channel.name));
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      gbuffer.lookups[pixel].*channel.member = values[pixel * stride + offset];
    }
  }
  if (!options.allow_non_finite) check_finite(path, gbuffer);
  return gbuffer;
}

void write_gbuffer(const std::filesystem::path& path, const GBuffer& gbuffer) {
  OutputFiles one;
  write_gbuffer(one, path, gbuffer);
  one.commit();
}

void write_gbuffer(OutputFiles& outputs, const std::filesystem::path& path, const GBuffer& gbuffer) {
  static_assert(sizeof(Lookup) == kChannels.size() * sizeof(float), "Lookup is a packed pixel");
  if (gbuffer.width < 1 || gbuffer.height < 1 ||
      gbuffer.lookups.size() != static_cast<std::size_t>(gbuffer.width) * static_cast<std::size_t>(gbuffer.height)) {
    throw std::invalid_argument("write_gbuffer: the lookups do not fill the picture");
  }
  OIIO::ImageSpec spec(gbuffer.width, gbuffer.height, static_cast<int>(kChannels.size()), OIIO::TypeDesc::FLOAT);
  std::ranges::transform(kChannels, spec.channelnames.begin(), &Channel::name);
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");  // otherwise the time of writing
  outputs.write(path, encode_image(path, "exr", spec, gbuffer.lookups.data()));
}

}  // namespace feline
