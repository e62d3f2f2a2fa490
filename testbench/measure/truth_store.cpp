// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/truth_store.h"

#include <cstring>
#include <stdexcept>
#include <utility>

#include "testbench/image.h"

namespace feline {
namespace {

struct Header {
  std::int64_t width, height, samples;
  double gaussian_error, box_error;
};

using Pixels = std::vector<std::array<float, 4>>;

std::string_view as_bytes(const Pixels& pixels) {
  return {reinterpret_cast<const char*>(pixels.data()), pixels.size() * sizeof(pixels[0])};
}

}  // namespace

std::string to_bytes(const Truth& truth) {
  const Header header{truth.gaussian.width, truth.gaussian.height, truth.samples, truth.gaussian_error,
                      truth.box_error};
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  bytes += as_bytes(truth.gaussian.pixels);
  bytes += as_bytes(truth.box.pixels);
  return bytes;
}

Truth truth_from_bytes(std::string_view bytes) {
  Header header{};
  if (bytes.size() < sizeof header) throw std::runtime_error("truth: too few bytes");
  std::memcpy(&header, bytes.data(), sizeof header);
  const auto is_side = [](std::int64_t side) { return side >= 1 && side <= kMaxImageSize; };
  if (!is_side(header.width) || !is_side(header.height) || !std::in_range<int>(header.samples)) {
    throw std::runtime_error("truth: no such picture");
  }
  const std::size_t count = static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
  const std::size_t size = count * sizeof(std::array<float, 4>);
  if (bytes.size() != sizeof header + 2 * size) throw std::runtime_error("truth: bytes do not fill the picture");
  const auto width = static_cast<int>(header.width);
  const auto height = static_cast<int>(header.height);
  Truth truth{{width, height, Pixels(count)},
              {width, height, Pixels(count)},
              header.gaussian_error,
              header.box_error,
              static_cast<int>(header.samples)};
  std::memcpy(truth.gaussian.pixels.data(), bytes.data() + sizeof header, size);
  std::memcpy(truth.box.pixels.data(), bytes.data() + sizeof header + size, size);
  return truth;
}

}  // namespace feline
