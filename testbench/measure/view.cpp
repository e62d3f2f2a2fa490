// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/view.h"

#include <algorithm>

#include "testbench/scenes/mesh.h"

namespace feline {
namespace {

reference::Lookup to_reference(const Lookup& lookup) {
  return {{double{lookup.s}, double{lookup.t}},
          {{double{lookup.dsdx}, double{lookup.dtdx}}, {double{lookup.dsdy}, double{lookup.dtdy}}}};
}

// Derivatives per picture to derivatives per pixel.
reference::Lookup to_reference(const TexturePoint& point, int width, int height) {
  return {{point.s.value, point.t.value},
          {{point.s.dx / width, point.t.dx / width}, {point.s.dy / height, point.t.dy / height}}};
}

// Where the middle of each quad is looked at; a middle outside the picture moves to its edge.
std::vector<reference::Lookup> quad_middles(const Scene& scene, const Mesh& mesh, int width, int height) {
  std::vector<reference::Lookup> middles;
  for (int row = 0; row < mesh.rows; ++row) {
    for (int column = 0; column < mesh.columns; ++column) {
      double x = 0;
      double y = 0;
      for (const int corner : {0, 1, mesh.columns + 1, mesh.columns + 2}) {
        const MeshVertex& vertex = mesh.vertices[static_cast<std::size_t>(row * (mesh.columns + 1) + column + corner)];
        x += vertex.x / 4;
        y += vertex.y / 4;
      }
      const TexturePoint point =
          scene.project(Dual(std::clamp(x, 0.0, 1.0), 1, 0), Dual(std::clamp(y, 0.0, 1.0), 0, 1));
      middles.push_back(to_reference(point, width, height));
    }
  }
  return middles;
}

std::vector<reference::Pixel> plain_pixels(const GBuffer& gbuffer) {
  std::vector<reference::Pixel> pixels;
  pixels.reserve(gbuffer.lookups.size());
  for (const Lookup& lookup : gbuffer.lookups) {
    const reference::Lookup own = to_reference(lookup);
    pixels.push_back({own, own, {}});
  }
  return pixels;
}

}  // namespace

Surface make_surface(Texture texture, const reference::Wrapping& wrapping, MipEdge edge,
                     std::span<const reference::Pyramid> wanted) {
  Surface surface;
  surface.images = make_images(texture, wrapping, edge, wanted);
  surface.memory = layout_texture(texture);
  surface.texture = std::move(texture);
  return surface;
}

View make_view(const Scene& scene, const Surface& surface, int width, int height) {
  View view{std::string(scene.name), &surface, make_gbuffer(scene, width, height), {}, {}, {}, {}};
  view.projection = [project = scene.project, width, height](double x, double y) {
    const TexturePoint point = project(Dual(x / width), Dual(y / height));
    return reference::Vector2<double>{point.s.value, point.t.value};
  };
  const Mesh mesh = scene_mesh(scene);
  view.pixels = plain_pixels(view.gbuffer);
  view.fragments = rasterise(mesh, width, height);
  const std::vector<reference::Lookup> middles = quad_middles(scene, mesh, width, height);
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    view.pixels[i].polygon_middle = middles[static_cast<std::size_t>(view.fragments[i].quad)];
  }
  for (const TexturePoint& point : vertex_points(scene, mesh)) {
    view.vertex_gradients.push_back(to_reference(point, width, height).gradients);
  }
  return view;
}

View make_view(std::string name, const Surface& surface, GBuffer gbuffer) {
  View view{std::move(name), &surface, std::move(gbuffer), {}, {}, {}, {}};
  view.pixels = plain_pixels(view.gbuffer);
  return view;
}

std::vector<reference::Gradients<double>> interpolate_axes(const View& view, reference::AxisSystem system) {
  const reference::Level& base = view.surface->images.lanczos.base();
  std::vector<reference::Gradients<double>> axes;
  axes.reserve(view.pixels.size());
  if (view.fragments.empty()) {
    for (const auto& pixel : view.pixels) {
      axes.push_back(reference::vertex_axes(system, pixel.lookup.gradients, base));
    }
    return axes;
  }
  std::vector<reference::Gradients<double>> at_vertices;
  for (const auto& gradients : view.vertex_gradients) {
    at_vertices.push_back(reference::vertex_axes(system, gradients, base));
  }
  for (const Fragment& fragment : view.fragments) {
    reference::Gradients<double> sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& vertex = at_vertices[static_cast<std::size_t>(fragment.vertices[i])];
      sum.x = sum.x + fragment.weights[i] * vertex.x;
      sum.y = sum.y + fragment.weights[i] * vertex.y;
    }
    axes.push_back(sum);
  }
  return axes;
}

Truth compute_truth(const View& view, int strata, std::uint64_t seed, Progress* progress) {
  const reference::MipMap& map = view.surface->images.lanczos;
  if (!view.projection) return compute_truth(map, view.gbuffer, strata, seed, progress);
  return compute_truth(map, view.projection, view.gbuffer.width, view.gbuffer.height, strata, seed, progress);
}

}  // namespace feline
