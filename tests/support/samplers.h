// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "model/memory.h"
#include "model/sampler.h"
#include "tests/support/random.h"

namespace feline {

using State = SamplerState<kDefaultConfig>;

enum class Content { kNoise, kConstant, kExtremes };

// A texture and what the unit reads of it.
struct TestScene {
  Texture texture;
  TextureMemory memory;
};

// A full chain, or its first `levels`, of random texels.
inline TestScene make_scene(Random& random, int width, int height, TexelFormat format, bool srgb, Content content,
                            int levels = 16) {
  TestScene scene;
  scene.texture.format = format;
  scene.texture.srgb = srgb;
  std::array<std::uint8_t, 4> constant{};
  for (auto& channel : constant) channel = static_cast<std::uint8_t>(random.bits());
  const auto channels = static_cast<std::size_t>(bytes_per_texel(format));
  for (int w = width, h = height, k = 0; k < levels; ++k) {
    MipLevel level{w, h,
                   std::vector<std::uint8_t>(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * channels)};
    for (std::size_t i = 0; i < level.texels.size(); ++i) {
      const auto noise = static_cast<std::uint8_t>(random.bits());
      level.texels[i] = content == Content::kConstant   ? constant[i % channels]
                        : content == Content::kExtremes ? static_cast<std::uint8_t>(noise < 128 ? 0 : 255)
                                                        : noise;
    }
    scene.texture.levels.push_back(std::move(level));
    if (w == 1 && h == 1) break;
    w = w > 1 ? w / 2 : 1;
    h = h > 1 ? h / 2 : 1;
  }
  scene.memory = layout_texture(scene.texture);
  return scene;
}

// Shapes that matter: 1 x 1, one wide, one high, odd, not powers of two, as wide and as high as can be.
inline constexpr std::array<std::array<int, 2>, 18> kShapes{{{1, 1},
                                                             {1, 2},
                                                             {2, 1},
                                                             {1, 37},
                                                             {64, 1},
                                                             {2, 2},
                                                             {3, 3},
                                                             {5, 7},
                                                             {4, 4},
                                                             {33, 17},
                                                             {64, 64},
                                                             {100, 60},
                                                             {127, 128},
                                                             {256, 16},
                                                             {16384, 1},
                                                             {1, 16383},
                                                             {255, 3},
                                                             {8, 200}}};

// Every shape in every format, linear and sRGB by turns, one in three without its coarsest levels.
inline std::vector<TestScene> make_scenes(Random& random, Content content) {
  std::vector<TestScene> scenes;
  for (const auto& [width, height] : kShapes) {
    for (const auto format : {TexelFormat::kR8, TexelFormat::kRg8, TexelFormat::kRgba8}) {
      const int levels = random.one_in(3) ? static_cast<int>(random.between(1, 4)) : 16;
      scenes.push_back(make_scene(random, width, height, format, random.one_in(2), content, levels));
    }
  }
  return scenes;
}

inline ProbeParameters random_parameters(Random& random) {
  switch (random.below(5)) {
    case 0: return kExact;
    case 1: return kHighQuality;
    case 2: return kHighEfficiency;
    default:
      return {random.one_in(2) ? ProbeRounding::kNearest : ProbeRounding::kCeiling,
              random.one_in(3) ? 1.0 : random.real(1.0 / 256, 1), random.one_in(3) ? 1.0 : random.real(1, 1.996),
              random.one_in(3) ? 1.0 : random.real(1, 2)};
  }
}

inline SamplerOptions random_options(Random& random) {
  SamplerOptions options;
  options.mode = static_cast<Mode>(random.below(6));
  options.kernel = static_cast<Kernel>(random.below(2));
  options.magnify = static_cast<Magnify>(random.below(2));
  options.wrap_s = static_cast<Wrap>(random.below(4));
  options.wrap_t = static_cast<Wrap>(random.below(4));
  options.probes = random_parameters(random);
  options.max_probes = random.one_in(2) ? 16 : static_cast<int>(random.between(1, 16));
  if (random.one_in(3)) options.level_bias = random.one_in(4) ? random.real(-16, 15.99) : random.real(-2, 2);
  if (random.one_in(4)) options.max_level = random.one_in(2) ? random.real(0, 3) : random.real(0, 15.99);
  if (random.one_in(4)) options.min_level = random.real(0, options.max_level);
  for (double& border : options.border)
    border = random.one_in(2) ? static_cast<double>(random.below(2)) : random.unit();
  return options;
}

// A full chain and nothing that shifts or clamps a level.
inline SamplerOptions plain_options(Mode mode) {
  SamplerOptions options;
  options.mode = mode;
  return options;
}

}  // namespace feline
