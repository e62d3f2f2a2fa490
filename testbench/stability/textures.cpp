// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/textures.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "testbench/mip_chain.h"

namespace feline::stability {
namespace {

MipLevel painted(int width, int height) {
  constexpr double kTurn = 6.283185307179586;
  MipLevel level{width, height, {}};
  for (int y = 0; y < height; ++y) {
    const double t = (y + 0.5) / height;
    for (int x = 0; x < width; ++x) {
      const double s = (x + 0.5) / width;
      const double waves =
          std::sin(kTurn * s) * std::cos(kTurn * t) + std::sin(kTurn * (2 * s + t)) + std::sin(kTurn * (s - 3 * t) + 1);
      level.texels.push_back(static_cast<std::uint8_t>(std::lround(127.5 + 42 * waves)));
    }
  }
  return level;
}

double texel(const MipLevel& level, int x, int y) {
  return level
      .texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(x)];
}

// Between texel centres at (i + 1/2)/size: the two neighbours, and the fraction between them.
struct Between {
  int low, high;
  double fraction;
};
Between between(double position, int size) {
  const double x = position * size - 0.5;
  const double low = std::floor(x);
  const int index = static_cast<int>(low);
  return {(index + size) % size, (index + 1) % size, x - low};
}

double interpolated(const MipLevel& level, const Between& x, const Between& y) {
  const auto along = [&](int row) {
    return texel(level, x.low, row) + x.fraction * (texel(level, x.high, row) - texel(level, x.low, row));
  };
  return along(y.low) + y.fraction * (along(y.high) - along(y.low));
}

// Texel centres of both levels along one axis. Between them both interpolations are bilinear, and so is their
// difference, whose extremes are therefore there.
std::vector<double> centres(int fine, int coarse) {
  std::vector<double> all;
  for (const int size : {fine, coarse}) {
    for (int i = 0; i < size; ++i) all.push_back((i + 0.5) / size);
  }
  return all;
}

double difference(const MipLevel& fine, const MipLevel& coarse) {
  double most = 0;
  const std::vector<double> columns = centres(fine.width, coarse.width);
  std::vector<std::array<Between, 2>> across;
  for (const double s : columns) across.push_back({between(s, fine.width), between(s, coarse.width)});
  for (const double t : centres(fine.height, coarse.height)) {
    const Between fine_y = between(t, fine.height);
    const Between coarse_y = between(t, coarse.height);
    for (const auto& [fine_x, coarse_x] : across) {
      most = std::max(most, std::abs(interpolated(fine, fine_x, fine_y) - interpolated(coarse, coarse_x, coarse_y)));
    }
  }
  return most;
}

LevelSlope slope_of(const MipLevel& level) {
  LevelSlope slope;
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x) {
      const double here = texel(level, x, y);
      slope.s = std::max(slope.s, level.width * std::abs(here - texel(level, (x + 1) % level.width, y)));
      slope.t = std::max(slope.t, level.height * std::abs(here - texel(level, x, (y + 1) % level.height)));
    }
  }
  const auto [least, most] = std::ranges::minmax(level.texels);
  slope.range = most - least;
  return slope;
}

SamplerState<kDefaultConfig> sampler_of(Mode mode, const Texture& texture, const TextureMemory& memory) {
  SamplerOptions options;
  options.mode = mode;
  return make_sampler<kDefaultConfig>(options, texture, memory);
}

}  // namespace

TestTexture::TestTexture(int width, int height) {
  texture_.format = TexelFormat::kR8;
  texture_.levels = build_mip_chain(painted(width, height), 1, MipFilter::kBox, false, MipEdge::kRepeat);
  memory_ = layout_texture(texture_);
  simple_ = sampler_of(Mode::kSimple, texture_, memory_);
  table_ = sampler_of(Mode::kTable, texture_, memory_);
  LevelSlope from_here;
  for (std::size_t k = texture_.levels.size(); k-- > 0;) {
    LevelSlope slope = slope_of(texture_.levels[k]);
    if (k + 1 < texture_.levels.size()) slope.to_next = difference(texture_.levels[k], texture_.levels[k + 1]);
    from_here = {std::max(from_here.s, slope.s), std::max(from_here.t, slope.t),
                 std::max(from_here.to_next, slope.to_next), std::max(from_here.range, slope.range)};
    slopes_.push_back(from_here);
  }
  std::ranges::reverse(slopes_);
}

const LevelSlope& TestTexture::slope_from(int finest) const {
  return slopes_[static_cast<std::size_t>(std::clamp(finest, 0, last_level()))];
}

bool TestTexture::exact_in_texels() const {
  return std::has_single_bit(static_cast<unsigned>(width())) && std::has_single_bit(static_cast<unsigned>(height()));
}

const std::vector<std::unique_ptr<TestTexture>>& test_textures() {
  static const std::vector<std::unique_ptr<TestTexture>> all = [] {
    std::vector<std::unique_ptr<TestTexture>> made;
    for (const auto& [width, height] : {std::pair{256, 256},
                                        {16384, 16},
                                        {16, 16384},
                                        {16384, 1},
                                        {1, 16384},
                                        {16383, 11},
                                        {1000, 7},
                                        {3, 5},
                                        {2, 1},
                                        {1, 1}}) {
      made.push_back(std::make_unique<TestTexture>(width, height));
    }
    return made;
  }();
  return all;
}

}  // namespace feline::stability
