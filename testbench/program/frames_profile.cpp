// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/frames_profile.h"

namespace feline {

const ProfiledTexture& ProfiledTextures::of(const Frame& frame) {
  auto found = textures_.find(frame.texture_number);
  if (found == textures_.end()) {
    // A texture has two mip chains at most; the oldest is one that does not come again.
    constexpr std::size_t kMostChains = 2;
    if (textures_.size() == kMostChains) textures_.erase(textures_.begin());
    found = textures_.emplace(frame.texture_number, profiled_texture(frame.texture_name, frame.texture)).first;
  }
  return found->second;
}

Profile profile_of(const FrameOptions& frames) {
  Profile profile;
  ProfiledTextures textures;
  frames.for_each("profiling", [&](const Frame& frame, Progress& progress) {
    const auto sampler = prepare_sampler(frame.sampler, frame.texture, frame.memory);
    observe(profile, frame.source, frame.gbuffer.lookups, sampler, frame.memory, textures.of(frame), &progress);
  });
  return profile;
}

}  // namespace feline
