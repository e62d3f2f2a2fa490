// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/gradients.h"
#include "model/reference/mip_map.h"

namespace feline::reference {

// One lookup, finite: normalized coordinates and how they move a pixel to the right and a pixel down.
struct Lookup {
  Vector2<double> position;
  Gradients<double> gradients;
};

// The gradients in texels of an image.
inline Gradients<double> in_texels(const Gradients<double>& normalized, const Level& level) {
  const auto scale = [&](const Vector2<double>& v) { return Vector2<double>{v.u * level.width, v.v * level.height}; };
  return {scale(normalized.x), scale(normalized.y)};
}

// From texels of an image to normalized coordinates.
inline Vector2<double> normalized(const Vector2<double>& texels, const Level& level) {
  return {texels.u / level.width, texels.v / level.height};
}

}  // namespace feline::reference
