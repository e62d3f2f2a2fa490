// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "model/lookup.h"
#include "model/memory.h"
#include "tables/sampler_state.h"
#include "testbench/progress.h"
#include "testbench/prune/profile.h"

namespace feline {

// A texture, ready to be profiled.
struct ProfiledTexture {
  std::string hash;
  TextureUse unread;  // its shape; nothing of it is read yet
};
ProfiledTexture profiled_texture(const std::string& name, const Texture& texture);

// One G-buffer more of a source, sampled by the model in one texture under one sampler, on all processors. `sampler`
// and `memory` are the texture's own. Progress advances by a lookup each.
void observe(Profile& profile, const std::string& source, std::span<const Lookup> lookups,
             const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory, const ProfiledTexture& texture,
             Progress* progress = nullptr);

// The least configuration for one lookup: that of its profile.
Config needed_config(const Lookup& lookup, const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory);

}  // namespace feline
