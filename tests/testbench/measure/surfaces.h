// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "testbench/measure/truth.h"
#include "testbench/random.h"
#include "testbench/scenes/scene.h"

// Surfaces and pictures whose truth is known in another way.
namespace feline {

// value(i, j) of each texel, grey.
template <typename Value>
reference::MipMap grey_map(int width, int height, const reference::Wrapping& wrapping, Value value) {
  reference::Level level{width, height, {}};
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const auto v = static_cast<float>(value(i, j));
      level.texels.push_back({v, v, v, 1});
    }
  }
  return {{std::move(level)}, wrapping};
}

inline reference::MipMap noise_map(int size, std::uint64_t seed) {
  SplitMix64 random(seed);
  return grey_map(size, size, {}, [&](int, int) { return random.unit(); });
}

// A built-in scene with a texture that is soon made: colours that belong together, as in a picture.
template <int kChannels>
MipLevel paint_small() {
  constexpr int kSide = 64;
  SplitMix64 random(17);
  MipLevel level{kSide, kSide, {}};
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const int bright = (i / 8 + j / 8) % 2 == 0 ? 40 : 180;
      for (int c = 0; c < kChannels; ++c) {
        level.texels.push_back(static_cast<std::uint8_t>(c == 3 ? 255 : bright + static_cast<int>(random.below(60))));
      }
    }
  }
  return level;
}
inline Scene small_scene(std::string_view name) {
  Scene scene = find_scene(name);
  scene.paint = scene.format == TexelFormat::kR8 ? paint_small<1> : paint_small<4>;
  return scene;
}

// Texels of level 0 from pixels, by a matrix and an origin.
struct Affine {
  double u, v;  // at the picture's upper left corner
  double dudx, dvdx, dudy, dvdy;

  PictureProjection on(const reference::MipMap& map) const {
    return [*this, width = map.base().width, height = map.base().height](double x, double y) {
      return reference::Vector2<double>{(u + x * dudx + y * dudy) / width, (v + x * dvdx + y * dvdy) / height};
    };
  }
  GBuffer gbuffer(const reference::MipMap& map, int width, int height) const {
    const auto real = [](double value, int side) { return static_cast<float>(value / side); };
    const auto [columns, rows] = std::pair(map.base().width, map.base().height);
    GBuffer made{width, height, {}};
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const double x = column + 0.5;
        const double y = row + 0.5;
        made.lookups.push_back({real(u + x * dudx + y * dudy, columns), real(v + x * dvdx + y * dvdy, rows),
                                real(dudx, columns), real(dvdx, rows), real(dudy, columns), real(dvdy, rows)});
      }
    }
    return made;
  }
};

// Root mean square of red between two pictures; want(column, row) for a picture that is known in closed form.
template <typename Want>
double rms_from(const FloatPicture& picture, Want want) {
  double sum = 0;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const double apart = static_cast<double>(picture.at(column, row)[0]) - want(column, row);
      sum += apart * apart;
    }
  }
  return std::sqrt(sum / static_cast<double>(picture.pixels.size()));
}
inline double rms_between(const FloatPicture& a, const FloatPicture& b) {
  return rms_from(a, [&](int column, int row) { return static_cast<double>(b.at(column, row)[0]); });
}
template <typename Want>
double worst_from(const FloatPicture& picture, Want want) {
  double worst = 0;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      worst = std::max(worst, std::abs(static_cast<double>(picture.at(column, row)[0]) - want(column, row)));
    }
  }
  return worst;
}

}  // namespace feline
