// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/memory.h"
#include "testbench/gbuffer.h"
#include "testbench/picture.h"

namespace feline {

// The model's picture of a G-buffer, with its plans. Shows progress when it takes long.
Picture render_model(const GBuffer& gbuffer, const SamplerState<kDefaultConfig>& sampler, const TextureMemory& memory);

}  // namespace feline
