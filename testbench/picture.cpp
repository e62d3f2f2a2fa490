// SPDX-License-Identifier: Apache-2.0
#include "testbench/picture.h"

#include <algorithm>
#include <array>

#include "tables/roms.h"
#include "testbench/image.h"

namespace feline {
namespace {

using Colour = std::array<int, 3>;

struct Anchor {
  int at;  // 1/256
  Colour colour;
};

// Linear between the anchors.
Colour ramp(std::span<const Anchor> anchors, int at) {
  for (std::size_t i = 1; i < anchors.size(); ++i) {
    const Anchor& low = anchors[i - 1];
    const Anchor& high = anchors[i];
    if (at > high.at && i + 1 < anchors.size()) continue;
    const int position = std::clamp(at, low.at, high.at) - low.at;
    Colour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] = low.colour[c] + (high.colour[c] - low.colour[c]) * position / (high.at - low.at);
    }
    return colour;
  }
  return anchors.front().colour;
}

using F = Formats<kDefaultConfig>;

// The sRGB code whose linear value is nearest to a raw pixel's; of two as near, the darker.
std::uint8_t srgb_code(std::int64_t linear) {
  const auto& words = roms<kDefaultConfig>().srgb.words;
  constexpr std::int64_t kScale = std::int64_t{1} << (F::kPixel.fraction_bits - F::kChannel.fraction_bits);
  const auto distance = [&](std::size_t code) {
    return std::abs(static_cast<std::int64_t>(words[code]) * kScale - linear);
  };
  const auto above = std::ranges::lower_bound(words, static_cast<std::uint64_t>((linear + kScale - 1) / kScale));
  const auto high = std::min<std::size_t>(static_cast<std::size_t>(above - words.begin()), 255);
  if (high == 0) return 0;
  return static_cast<std::uint8_t>(distance(high - 1) <= distance(high) ? high - 1 : high);
}

template <typename ColourOf>
void write_map(OutputFiles& outputs, const std::filesystem::path& path, const Picture& picture, ColourOf colour_of) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.plans.size() * 3);
  for (const auto& plan : picture.plans) {
    for (const int channel : colour_of(plan)) bytes.push_back(static_cast<std::uint8_t>(channel));
  }
  write_png(outputs, path, picture.width, picture.height, 3, std::span<const std::uint8_t>(bytes));
}

}  // namespace

void write_picture(OutputFiles& outputs, const std::filesystem::path& path, const Picture& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.pixels.size() * 4);
  for (const auto& pixel : picture.pixels) {
    for (std::size_t c = 0; c < 4; ++c) {
      const std::int64_t raw = pixel.colour[c].raw();
      bytes.push_back(picture.srgb && c < 3 ? srgb_code(raw)
                                            : static_cast<std::uint8_t>(round_up_ties(raw, F::kPixel.fraction_bits)));
    }
  }
  write_png(outputs, path, picture.width, picture.height, 4, std::span<const std::uint8_t>(bytes));
}

std::array<int, 3> probe_colour(int probes) {
  constexpr std::array<Anchor, 5> kAnchors{Anchor{0, {255, 255, 255}}, Anchor{256, {120, 190, 255}},
                                           Anchor{512, {20, 40, 160}}, Anchor{768, {0, 255, 0}},
                                           Anchor{1024, {255, 0, 0}}};
  // log2 of the count, piecewise linear between powers of two.
  probes = std::max(probes, 1);
  const int top = bit_length(probes) - 1;
  return ramp(kAnchors, 256 * top + ((probes - (1 << top)) << 8 >> top));
}

void write_probe_map(OutputFiles& outputs, const std::filesystem::path& path, const Picture& picture) {
  write_map(outputs, path, picture,
            [](const PlanBeat<kDefaultConfig>& plan) { return probe_colour(static_cast<int>(plan.probes.raw())); });
}

void write_level_map(OutputFiles& outputs, const std::filesystem::path& path, const Picture& picture, int last_level) {
  const int span = std::max(last_level, 1) * static_cast<int>(F::kSampledLevel.one());
  const std::array<Anchor, 6> anchors{Anchor{0, {220, 40, 40}},
                                      Anchor{span / 5, {240, 170, 30}},
                                      Anchor{span * 2 / 5, {230, 230, 60}},
                                      Anchor{span * 3 / 5, {60, 180, 75}},
                                      Anchor{span * 4 / 5, {40, 110, 220}},
                                      Anchor{span, {130, 40, 180}}};
  write_map(outputs, path, picture, [&](const PlanBeat<kDefaultConfig>& plan) {
    return ramp(anchors, static_cast<int>(plan.level_of_detail.raw()));
  });
}

}  // namespace feline
