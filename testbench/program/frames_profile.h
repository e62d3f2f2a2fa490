// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "testbench/program/frames.h"
#include "testbench/prune/observe.h"

namespace feline {

// The textures of frames, ready to be profiled: the last ones only, whatever the length of a sequence.
class ProfiledTextures {
 public:
  const ProfiledTexture& of(const Frame& frame);

 private:
  std::map<int, ProfiledTexture> textures_;
};

// What the frames of a command line reach, in one pass.
Profile profile_of(const FrameOptions& frames);

}  // namespace feline
