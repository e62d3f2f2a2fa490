// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "model/sampler.h"
#include "testbench/gbuffer.h"
#include "testbench/prune/observe.h"
#include "testbench/random.h"
#include "testbench/scenes/scene.h"

namespace feline {

// A texture of one colour that is laid out and ready to be profiled.
struct TestTexture {
  Texture texture;
  TextureMemory memory;
  ProfiledTexture profiled;

  explicit TestTexture(Texture made, const std::string& name = "test")
      : texture(std::move(made)), memory(layout_texture(texture)), profiled(profiled_texture(name, texture)) {}

  void observe_in(Profile& profile, const std::vector<Lookup>& lookups, const SamplerOptions& options,
                  const std::string& source = "test") const {
    observe(profile, source, lookups, make_sampler<kDefaultConfig>(options, texture, memory), memory, profiled);
  }
  Profile profile(const std::vector<Lookup>& lookups, const SamplerOptions& options) const {
    Profile made;
    observe_in(made, lookups, options);
    return made;
  }
  const TextureUse& use_in(const Profile& profile) const { return profile.textures.at(profiled.hash); }
};

inline Texture flat_texture(int width, int height, std::uint8_t alpha = 255) {
  Texture texture;
  for (;; width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
    MipLevel level{width, height, {}};
    for (int texel = 0; texel < width * height; ++texel) level.texels.insert(level.texels.end(), {10, 20, 30, alpha});
    texture.levels.push_back(std::move(level));
    if (width == 1 && height == 1) return texture;
  }
}

// At texel coordinates, with derivatives in texels of level 0.
struct TexelLookup {
  double u, v, dudx, dvdx, dudy, dvdy;

  Lookup in(int width, int height) const {
    const auto real = [](double value, int side) { return static_cast<float>(value / side); };
    return {real(u, width),     real(v, height),   real(dudx, width),
            real(dvdx, height), real(dudy, width), real(dvdy, height)};
  }
};

// Anywhere within three textures of the first one, with footprints of all shapes from 1/8 to 64 texels.
inline std::vector<Lookup> random_lookups(std::uint64_t seed, int count) {
  SplitMix64 random(seed);
  const auto unit = [&] { return static_cast<float>(random.below(1 << 20)) / static_cast<float>(1 << 20); };
  const auto gradient = [&] { return (unit() - 0.5F) * std::exp2(-9 * unit()) * 0.5F; };
  std::vector<Lookup> lookups;
  for (int i = 0; i < count; ++i) {
    lookups.push_back({6 * unit() - 3, 6 * unit() - 3, gradient(), gradient(), gradient(), gradient()});
  }
  return lookups;
}

}  // namespace feline
