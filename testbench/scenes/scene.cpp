// SPDX-License-Identifier: Apache-2.0
#include "testbench/scenes/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "testbench/error.h"
#include "testbench/image.h"
#include "testbench/scenes/builtin.h"

namespace feline {
namespace {

TexturePoint project_at(const Scene& scene, double x, double y) {
  return scene.project(Dual(x, 1.0, 0.0), Dual(y, 0.0, 1.0));
}

// x_step and y_step: the size of a pixel, in pictures.
Lookup round_lookup(const TexturePoint& point, double x_step, double y_step) {
  return {static_cast<float>(point.s.value),       static_cast<float>(point.t.value),
          static_cast<float>(point.s.dx * x_step), static_cast<float>(point.t.dx * x_step),
          static_cast<float>(point.s.dy * y_step), static_cast<float>(point.t.dy * y_step)};
}

void check_side(const Scene& scene, std::string_view field, int size) {
  if (size < 1 || size > kMaxImageSize) {
    bad_input(fmt::format("scene {}", scene.name), field, std::to_string(size), fmt::format("1 to {}", kMaxImageSize));
  }
}

}  // namespace

Texture Scene::texture(MipFilter filter, MipEdge edge) const {
  return {format, srgb, build_mip_chain(paint(), bytes_per_texel(format), filter, srgb, edge)};
}

Lookup Scene::lookup(double x, double y) const { return round_lookup(project_at(*this, x, y), 1.0, 1.0); }

std::span<const Scene> scenes() {
  static const std::array all = {bricks_scene(),       curves_scene(),        text_scene(),      checkerboard_scene(),
                                 runway_steep_scene(), runway_middle_scene(), runway_scene(),    runway_low_scene(),
                                 window_scene(),       sphere_scene(),        reflector_scene(), magnify_scene(),
                                 repeat_scene(),       tessellated_scene(),   spin_scene()};
  return all;
}

const Scene& find_scene(std::string_view name) {
  const auto found = std::ranges::find(scenes(), name, &Scene::name);
  if (found != scenes().end()) return *found;
  std::string legal;
  for (const Scene& scene : scenes()) {
    legal += fmt::format("{}{}", legal.empty() ? "" : ", ", scene.name);
  }
  bad_input("scene", "name", name, legal);
}

int frame_count(const Scene& scene) { return 1 + static_cast<int>(scene.later_frames.size()); }

Scene frame(const Scene& scene, int index) {
  if (index < 0 || index >= frame_count(scene)) {
    bad_input(fmt::format("scene {}", scene.name), "frame", std::to_string(index),
              fmt::format("0 to {}", frame_count(scene) - 1));
  }
  Scene still = scene;
  if (index > 0) still.project = scene.later_frames[static_cast<std::size_t>(index) - 1];
  still.later_frames = {};
  return still;
}

GBuffer make_gbuffer(const Scene& scene, int width, int height) {
  check_side(scene, "width", width);
  check_side(scene, "height", height);
  GBuffer gbuffer{width, height, {}};
  gbuffer.lookups.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const TexturePoint point = project_at(scene, (column + 0.5) / width, (row + 0.5) / height);
      gbuffer.lookups.push_back(round_lookup(point, 1.0 / width, 1.0 / height));
    }
  }
  return gbuffer;
}

}  // namespace feline
