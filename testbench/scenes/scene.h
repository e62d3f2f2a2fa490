// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "model/lookup.h"
#include "model/texture.h"
#include "testbench/gbuffer.h"
#include "testbench/mip_chain.h"
#include "testbench/scenes/dual.h"

namespace feline {

// Normalized texture coordinates, t downwards, and their derivatives per picture.
struct TexturePoint {
  Dual s;
  Dual t;
};

// A built-in view of a textured surface. Resolution-independent: a larger picture is the same view
// with more pixels. Every pixel hits the surface. Textures and lookups are the same bits on every
// host when compiled with -ffp-contract=off: they use + - * / and sqrt only.
struct Scene {
  std::string_view name;
  std::string_view description;  // one line, for --help
  TexelFormat format;
  bool srgb;
  MipLevel (*paint)();  // level 0
  // x and y in [0, 1] from the upper left corner of the picture, with derivatives 1, 0 and 0, 1.
  TexturePoint (*project)(const Dual& x, const Dual& y);

  // The texture with its whole chain; textures are periodic, and so are their levels, if they may.
  Texture texture(MipFilter filter = MipFilter::kLanczos, MipEdge edge = MipEdge::kRepeat) const;

  // Derivatives per picture width and height, not per pixel.
  Lookup lookup(double x, double y) const;
};

// All scenes; the first is the default one.
std::span<const Scene> scenes();

// Throws InputError listing the legal names.
const Scene& find_scene(std::string_view name);

// The lookups at the centres of width x height pixels, derivatives per pixel: evaluated in double
// and rounded to float32 once. Throws InputError unless both sides are 1 to kMaxImageSize.
GBuffer make_gbuffer(const Scene& scene, int width, int height);

}  // namespace feline
