// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/exhibit.h"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/measure/cache.h"

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

ExhibitPlan plan_exhibit(const std::filesystem::path& gbuffer_path, const std::filesystem::path& texture_path,
                         const ImageOptions& image, Wrap wrap) {
  GBuffer gbuffer = read_gbuffer(gbuffer_path);
  ExhibitPlan plan;
  plan.name = gbuffer_path.stem().string();
  plan.description = fmt::format("{} with {}", gbuffer_path.filename().string(), texture_path.filename().string());
  plan.width = gbuffer.width;
  plan.height = gbuffer.height;
  plan.perspective = false;
  plan.identity = fmt::format("own {} {} {} {}", content_hash(gbuffer_path), content_hash(texture_path), image.srgb,
                              static_cast<int>(wrap));
  plan.build = [name = plan.name, gbuffer = std::move(gbuffer), texture_path, image, wrap] {
    Exhibit exhibit;
    exhibit.surface =
        std::make_unique<Surface>(make_surface(load_texture(texture_path, image), {wrap, wrap, {}}, image.mip_edge));
    exhibit.frames.push_back(make_view(name, *exhibit.surface, gbuffer));
    return exhibit;
  };
  return plan;
}

}  // namespace feline
