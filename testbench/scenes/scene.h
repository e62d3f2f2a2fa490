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

// Where the surface at (x, y) is in the texture; x and y in [0, 1] from the upper left corner of the
// picture, with derivatives 1, 0 and 0, 1.
using Projection = TexturePoint(const Dual& x, const Dual& y);

struct Mesh;  // mesh.h

// A built-in view of a textured surface. Resolution-independent: a larger picture is the same view
// with more pixels. Every pixel hits the surface. Textures and lookups are the same bits on every
// host when compiled with -ffp-contract=off: they use + - * / and sqrt only.
struct Scene {
  std::string_view name;
  std::string_view description;  // one line, for --help
  TexelFormat format;
  bool srgb;
  MipLevel (*paint)();  // level 0
  Projection* project;

  // A sequence: the projections of the frames after the first; empty for a still.
  std::span<Projection* const> later_frames = {};
  // The polygons of the surface; null where it has none of its own (scene_mesh).
  Mesh (*mesh)() = nullptr;

  // The texture with its whole chain; textures are periodic, and so are their levels, if they may.
  Texture texture(MipFilter filter = MipFilter::kLanczos, MipEdge edge = MipEdge::kRepeat) const;

  // Derivatives per picture width and height, not per pixel.
  Lookup lookup(double x, double y) const;
};

// All scenes; the first is the default one.
std::span<const Scene> scenes();

// Throws InputError listing the legal names.
const Scene& find_scene(std::string_view name);

int frame_count(const Scene& scene);

// One frame of a sequence as a still; frame 0 of a still is itself. Throws InputError unless index is
// 0 to frame_count - 1.
Scene frame(const Scene& scene, int index);

// The lookups at the centres of width x height pixels, derivatives per pixel: evaluated in double
// and rounded to float32 once. Throws InputError unless both sides are 1 to kMaxImageSize.
GBuffer make_gbuffer(const Scene& scene, int width, int height);

}  // namespace feline
