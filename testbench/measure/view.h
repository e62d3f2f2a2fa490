// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/memory.h"
#include "model/reference/filters.h"
#include "testbench/gbuffer.h"
#include "testbench/measure/images.h"
#include "testbench/measure/truth.h"
#include "testbench/mip_chain.h"
#include "testbench/scenes/mesh.h"
#include "testbench/scenes/scene.h"

namespace feline {

// A texture that is looked at, in the pyramids that something wants.
struct Surface {
  Texture texture;  // Lanczos mip levels
  TextureMemory memory;
  reference::Images images;
};
Surface make_surface(Texture texture, const reference::Wrapping& wrapping, MipEdge edge,
                     std::span<const reference::Pyramid> wanted = kAllPyramids);

// One picture to be made of it.
struct View {
  std::string name;
  const Surface* surface = nullptr;
  GBuffer gbuffer;
  PictureProjection projection;          // none for a G-buffer of a user's own
  std::vector<reference::Pixel> pixels;  // what the filters are told, but for the axes
  std::vector<Fragment> fragments;       // of the scene's mesh, one a pixel; none for a G-buffer of a user's own
  std::vector<reference::Gradients<double>> vertex_gradients;  // of the mesh, per pixel
};

// The view of a scene, or of one frame of it.
View make_view(const Scene& scene, const Surface& surface, int width, int height);
// A G-buffer has no mesh: each pixel is its own polygon.
View make_view(std::string name, const Surface& surface, GBuffer gbuffer);

// The axes of vertex-based texturing at each pixel: computed at the vertices, interpolated.
std::vector<reference::Gradients<double>> interpolate_axes(const View& view, reference::AxisSystem system);

Truth compute_truth(const View& view, int strata, std::uint64_t seed, Progress* progress);

}  // namespace feline
