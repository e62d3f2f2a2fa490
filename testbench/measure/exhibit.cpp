// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/exhibit.h"

#include <fmt/format.h>

#include <algorithm>

namespace feline {
namespace {

Exhibit build_scene(const Scene& scene, int width, int height, int frame_count) {
  Exhibit exhibit;
  exhibit.surface = std::make_unique<Surface>(make_surface(scene.texture(), {}, MipEdge::kRepeat));
  for (int i = 0; i < frame_count; ++i) {
    exhibit.frames.push_back(make_view(frame(scene, i), *exhibit.surface, width, height));
  }
  return exhibit;
}

}  // namespace

ExhibitPlan plan_exhibit(const Scene& scene, int width, int height) {
  ExhibitPlan plan;
  plan.name = scene.name;
  plan.description = scene.description;
  plan.frame_count = frame_count(scene);
  const int divisor = plan.frame_count > 1 ? 2 : 1;
  plan.width = std::max(width / divisor, 1);
  plan.height = std::max(height / divisor, 1);
  plan.identity = fmt::format("scene {} {}x{}", plan.name, plan.width, plan.height);
  plan.build = [scene, plan_width = plan.width, plan_height = plan.height, frames = plan.frame_count] {
    return build_scene(scene, plan_width, plan_height, frames);
  };
  return plan;
}

}  // namespace feline
