// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "model/reference/filters.h"
#include "model/texture.h"
#include "testbench/mip_chain.h"

namespace feline {

// Stored texels as the unit decodes them, in double where it has 12 bits: missing channels are 0, alpha 1; sRGB to
// linear light (IEC 61966-2-1). The border has the texture's channels only.
reference::Level to_reference(const MipLevel& level, TexelFormat format, bool srgb);
reference::MipMap to_reference(const Texture& texture, const reference::Wrapping& wrapping);

// The pyramids of a texture: Lanczos levels, always, which are the texture's own, and of the others, which are made
// from its level 0, those that are wanted.
inline constexpr std::array kAllPyramids{reference::Pyramid::kLanczos, reference::Pyramid::kBox,
                                         reference::Pyramid::kRip};
reference::Images make_images(const Texture& texture, const reference::Wrapping& wrapping, MipEdge edge,
                              std::span<const reference::Pyramid> wanted = kAllPyramids);

}  // namespace feline
