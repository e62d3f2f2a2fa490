// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/view.h"

#include <gtest/gtest.h>

#include "tests/testbench/measure/surfaces.h"

namespace feline {
namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 18;

using reference::AxisSystem;
using Gradients = reference::Gradients<double>;

void expect_near(const Gradients& got, const Gradients& want, double part) {
  const double all = length(want.x) + length(want.y);
  EXPECT_NEAR(got.x.u, want.x.u, part * all);
  EXPECT_NEAR(got.x.v, want.x.v, part * all);
  EXPECT_NEAR(got.y.u, want.y.u, part * all);
  EXPECT_NEAR(got.y.v, want.y.v, part * all);
}

// How the surface moves a pixel to the right and down, from nothing but where its points are.
Gradients differences(const View& view, double x, double y) {
  constexpr double kStep = 1e-3;
  const auto along = [&](double dx, double dy) {
    return (0.5 / kStep) *
           (view.projection(x + kStep * dx, y + kStep * dy) - view.projection(x - kStep * dx, y - kStep * dy));
  };
  return {along(1, 0), along(0, 1)};
}

// Of a pixel by its number.
struct Point {
  double x, y;
};
Point middle_of(int pixel) {
  const int row = pixel / kWidth;
  return {pixel - row * kWidth + 0.5, row + 0.5};
}

class measure_view : public testing::Test {  // NOLINT(readability-identifier-naming): the suite's name
 protected:
  static View view_of(std::string_view name) {
    static const Surface surface = make_surface(small_scene("bricks").texture(), {}, MipEdge::kRepeat);
    return make_view(small_scene(name), surface, kWidth, kHeight);
  }
};

TEST_F(measure_view, pixels_are_the_projections_middles) {
  const View view = view_of("tessellated");
  ASSERT_EQ(view.pixels.size(), std::size_t{kWidth * kHeight});
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const auto [x, y] = middle_of(i);
    const auto& lookup = view.pixels[static_cast<std::size_t>(i)].lookup;
    const auto at = view.projection(x, y);
    EXPECT_NEAR(lookup.position.u, at.u, 1e-6);
    EXPECT_NEAR(lookup.position.v, at.v, 1e-6);
    expect_near(lookup.gradients, differences(view, x, y), 1e-4);
  }
}

TEST_F(measure_view, vertices_have_the_surfaces_gradients) {
  const View view = view_of("tessellated");
  const Mesh mesh = scene_mesh(find_scene("tessellated"));
  ASSERT_EQ(view.vertex_gradients.size(), mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    expect_near(view.vertex_gradients[i], differences(view, mesh.vertices[i].x * kWidth, mesh.vertices[i].y * kHeight),
                1e-3);
  }
}

// At a vertex they are its own; between three, what is between their axes.
TEST_F(measure_view, axes_are_interpolated_from_vertices) {
  View view = view_of("tessellated");
  ASSERT_EQ(view.fragments.size(), std::size_t{kWidth * kHeight});
  view.fragments[0].weights = {1, 0, 0};
  view.fragments[1].weights = {0, 0, 1};
  for (const AxisSystem system : {AxisSystem::kEllipse, AxisSystem::kScreen, AxisSystem::kMax}) {
    const auto at_vertex = [&](std::size_t pixel, std::size_t corner) {
      const auto vertex = static_cast<std::size_t>(view.fragments[pixel].vertices[corner]);
      return reference::vertex_axes(system, view.vertex_gradients[vertex], view.surface->images.lanczos.base());
    };
    const auto axes = interpolate_axes(view, system);
    ASSERT_EQ(axes.size(), view.pixels.size());
    expect_near(axes[0], at_vertex(0, 0), 1e-12);
    expect_near(axes[1], at_vertex(1, 2), 1e-12);
    for (std::size_t i = 2; i < axes.size(); ++i) {
      const std::array<Gradients, 3> corners{at_vertex(i, 0), at_vertex(i, 1), at_vertex(i, 2)};
      const auto& w = view.fragments[i].weights;
      expect_near(axes[i],
                  {w[0] * corners[0].x + w[1] * corners[1].x + w[2] * corners[2].x,
                   w[0] * corners[0].y + w[1] * corners[1].y + w[2] * corners[2].y},
                  1e-12);
    }
  }
}

// A scene without a mesh has 16 x 16 equal quads.
TEST_F(measure_view, a_quads_middle_is_where_it_is_looked_at) {
  const View view = view_of("bricks");
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const Point pixel = middle_of(i);
    const double x = (std::floor(pixel.x / kWidth * 16) + 0.5) / 16 * kWidth;
    const double y = (std::floor(pixel.y / kHeight * 16) + 0.5) / 16 * kHeight;
    // On an edge either quad may have it.
    if (std::abs(x - pixel.x) > 0.499 * kWidth / 16 || std::abs(y - pixel.y) > 0.499 * kHeight / 16) continue;
    const auto& middle = view.pixels[static_cast<std::size_t>(i)].polygon_middle;
    const auto at = view.projection(x, y);
    EXPECT_NEAR(middle.position.u, at.u, 1e-9);
    EXPECT_NEAR(middle.position.v, at.v, 1e-9);
    expect_near(middle.gradients, differences(view, x, y), 1e-5);
  }
}

TEST_F(measure_view, a_frame_is_a_view_of_its_own) {
  const Surface surface = make_surface(small_scene("spin").texture(), {}, MipEdge::kRepeat);
  const View first = make_view(frame(small_scene("spin"), 0), surface, kWidth, kHeight);
  const View last = make_view(frame(small_scene("spin"), 7), surface, kWidth, kHeight);
  EXPECT_EQ(first.name, "spin");
  EXPECT_NE(first.gbuffer.lookups[0].s, last.gbuffer.lookups[0].s);
  EXPECT_NEAR(last.projection(0.5, 0.5).u, last.pixels[0].lookup.position.u, 1e-6);
}

// No mesh: each pixel is its own polygon and its own vertex.
TEST_F(measure_view, a_gbuffer_knows_its_pixels_only) {
  const View scene = view_of("tessellated");
  const View view = make_view("own", *scene.surface, scene.gbuffer);
  EXPECT_EQ(view.name, "own");
  EXPECT_FALSE(view.projection);
  EXPECT_TRUE(view.fragments.empty());
  const auto axes = interpolate_axes(view, AxisSystem::kMax);
  ASSERT_EQ(axes.size(), view.pixels.size());
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const reference::Pixel& pixel = view.pixels[i];
    expect_near(pixel.lookup.gradients, scene.pixels[i].lookup.gradients, 0);
    expect_near(pixel.polygon_middle.gradients, pixel.lookup.gradients, 0);
    EXPECT_EQ(pixel.polygon_middle.position.u, pixel.lookup.position.u);
    expect_near(axes[i],
                reference::vertex_axes(AxisSystem::kMax, pixel.lookup.gradients, view.surface->images.lanczos.base()),
                0);
  }
  // Its truth is affine; a scene's is not.
  EXPECT_EQ(compute_truth(view, 2, 1, nullptr).gaussian.pixels,
            compute_truth(view.surface->images.lanczos, view.gbuffer, 2, 1, nullptr).gaussian.pixels);
  EXPECT_EQ(
      compute_truth(scene, 2, 1, nullptr).gaussian.pixels,
      compute_truth(scene.surface->images.lanczos, scene.projection, kWidth, kHeight, 2, 1, nullptr).gaussian.pixels);
}

}  // namespace
}  // namespace feline
