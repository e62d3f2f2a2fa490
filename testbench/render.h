// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/memory.h"
#include "model/shortcuts.h"
#include "testbench/gbuffer.h"
#include "testbench/lazy_texture.h"
#include "testbench/picture.h"

namespace feline {

// The model's picture of a G-buffer, with its plans. Shows progress when it takes long.
Picture render_model(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory);

// The same picture, bit for bit, with less work, which `counts` tells; of a lazy texture only what is touched is
// loaded.
Picture render_shortcuts(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler,
                         const TextureMemory& memory, ShortcutCounts& counts, const Shortcuts& shortcuts = {});
Picture render_shortcuts(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler, LazyTexture& texture,
                         ShortcutCounts& counts, const Shortcuts& shortcuts = {});

}  // namespace feline
