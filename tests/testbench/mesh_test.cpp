// SPDX-License-Identifier: Apache-2.0
#include "testbench/scenes/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace feline {
namespace {

constexpr std::array<std::pair<int, int>, 7> kSizes = {
    {{1, 1}, {1, 7}, {16, 16}, {33, 20}, {97, 31}, {128, 128}, {512, 512}}};

// The message of the std::invalid_argument that it throws, or nothing.
template <typename Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

// Calls visit(fragment, x, y), the pixel centre in pictures.
template <typename Visit>
void for_each_fragment(const Mesh& mesh, int width, int height, Visit visit) {
  const std::vector<Fragment> fragments = rasterise(mesh, width, height);
  ASSERT_EQ(fragments.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  auto fragment = fragments.begin();
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) visit(*fragment++, (column + 0.5) / width, (row + 0.5) / height);
  }
}

template <typename Attribute>
double interpolate(const Fragment& fragment, Attribute attribute) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += fragment.weights[i] * attribute(static_cast<std::size_t>(fragment.vertices[i]));
  }
  return sum;
}

TEST(mesh, a_scene_without_one_gets_equal_quads) {
  const Mesh mesh = scene_mesh(find_scene("bricks"));
  EXPECT_EQ(mesh.columns, 16);
  EXPECT_EQ(mesh.rows, 16);
  ASSERT_EQ(mesh.vertices.size(), 17u * 17u);
  EXPECT_EQ(mesh.vertices[17 * 3 + 5].x, 5.0 / 16);
  EXPECT_EQ(mesh.vertices[17 * 3 + 5].y, 3.0 / 16);
  for (const MeshVertex& vertex : mesh.vertices) EXPECT_EQ(vertex.w, 1.0);
}

TEST(mesh, affine_weights_reproduce_the_position) {
  const Mesh mesh = scene_mesh(find_scene("bricks"));
  for (const auto& [width, height] : kSizes) {
    for_each_fragment(mesh, width, height, [&](const Fragment& fragment, double x, double y) {
      ASSERT_NEAR(interpolate(fragment, [](std::size_t) { return 1.0; }), 1.0, 1e-14);
      ASSERT_NEAR(interpolate(fragment, [&](std::size_t i) { return mesh.vertices[i].x; }), x, 1e-13);
      ASSERT_NEAR(interpolate(fragment, [&](std::size_t i) { return mesh.vertices[i].y; }), y, 1e-13);
      ASSERT_EQ(fragment.quad, static_cast<int>(std::ceil(y * 16) - 1) * 16 + static_cast<int>(std::ceil(x * 16) - 1));
    });
  }
}

// Sides of 16 put pixel centres on diagonals, sides of 8 on edges: the first of two triangles has them.
TEST(mesh, a_shared_edge_goes_to_the_first) {
  const std::vector<Fragment> on_diagonals = rasterise(scene_mesh(find_scene("bricks")), 16, 16);
  for (const Fragment& fragment : on_diagonals) {
    EXPECT_EQ(fragment.vertices[1], fragment.vertices[0] + 1);  // above the diagonal
    EXPECT_EQ(fragment.vertices[2], fragment.vertices[0] + 18);
  }
  const std::vector<Fragment> on_corners = rasterise(scene_mesh(find_scene("bricks")), 8, 8);
  EXPECT_EQ(on_corners[0].quad, 0);
  EXPECT_EQ(on_corners[9].quad, 2 * 16 + 2);
}

// Only perspective-correct weights do this: the plane is steep.
TEST(mesh, perspective_weights_reproduce_the_projection) {
  const Scene& scene = find_scene("tessellated");
  const Mesh mesh = scene_mesh(scene);
  const std::vector<TexturePoint> points = vertex_points(scene, mesh);
  ASSERT_EQ(points.size(), mesh.vertices.size());
  for (const auto& [width, height] : kSizes) {
    for_each_fragment(mesh, width, height, [&](const Fragment& fragment, double x, double y) {
      const TexturePoint expected = scene.project(Dual(x), Dual(y));
      ASSERT_NEAR(interpolate(fragment, [](std::size_t) { return 1.0; }), 1.0, 1e-14);
      ASSERT_NEAR(interpolate(fragment, [&](std::size_t i) { return points[i].s.value; }), expected.s.value, 1e-9);
      ASSERT_NEAR(interpolate(fragment, [&](std::size_t i) { return points[i].t.value; }), expected.t.value, 1e-9);
      for (const double weight : fragment.weights) ASSERT_GE(weight, 0.0);
    });
  }
}

TEST(mesh, the_tessellated_ground_reaches_beyond_the_picture_in_front_of_the_camera) {
  const Mesh mesh = scene_mesh(find_scene("tessellated"));
  MeshVertex low{1, 1, 1};
  MeshVertex high{0, 0, 0};
  for (const MeshVertex& vertex : mesh.vertices) {
    EXPECT_GT(vertex.w, 0.3);
    low = {std::min(low.x, vertex.x), std::min(low.y, vertex.y), std::min(low.w, vertex.w)};
    high = {std::max(high.x, vertex.x), std::max(high.y, vertex.y), std::max(high.w, vertex.w)};
  }
  EXPECT_LT(low.x, -0.1);
  EXPECT_LT(low.y, 0.0);
  EXPECT_GT(high.x, 1.1);
  EXPECT_GT(high.y, 1.1);
  EXPECT_GT(high.w / low.w, 10);
}

// Its squares are half a texture repeat, along the texture's axes.
TEST(mesh, vertices_lie_on_the_texture) {
  const Scene& scene = find_scene("tessellated");
  const Mesh mesh = scene_mesh(scene);
  const std::vector<TexturePoint> points = vertex_points(scene, mesh);
  for (const TexturePoint& point : points) {
    EXPECT_NEAR(2 * point.s.value, std::round(2 * point.s.value), 1e-9);
    EXPECT_NEAR(2 * point.t.value, std::round(2 * point.t.value), 1e-9);
  }
  const MeshVertex& vertex = mesh.vertices[40];
  const Lookup lookup = scene.lookup(vertex.x, vertex.y);
  EXPECT_EQ(static_cast<float>(points[40].s.dx), lookup.dsdx);
  EXPECT_EQ(static_cast<float>(points[40].t.dy), lookup.dtdy);
}

// 2 x 2 vertices: one quad over the left part of the picture only.
TEST(mesh, a_hole_is_an_error) {
  const Mesh half{1, 1, {{0, 0, 1}, {0.6, 0, 1}, {0, 1, 1}, {0.6, 1, 1}}};
  EXPECT_EQ(refusal([&] { rasterise(half, 4, 2); }), "mesh: pixel 2, 0 is not covered");
  EXPECT_EQ(refusal([&] { rasterise(half, 1, 1); }), "");
  const Mesh line{1, 1, {{0, 0, 1}, {1, 1, 1}, {0, 0, 1}, {1, 1, 1}}};
  EXPECT_EQ(refusal([&] { rasterise(line, 1, 1); }), "mesh: pixel 0, 0 is not covered");
}

TEST(mesh, bad_meshes_are_errors) {
  EXPECT_EQ(refusal([] { rasterise({2, 1, {{0, 0, 1}}}, 4, 4); }), "mesh: 1 vertices for 2 x 1 quads");
  EXPECT_EQ(refusal([] { rasterise({0, 0, {{0, 0, 1}}}, 4, 4); }), "mesh: 1 vertices for 0 x 0 quads");
  const Mesh behind{1, 1, {{0, 0, 1}, {1, 0, 0}, {0, 1, 1}, {1, 1, 1}}};
  EXPECT_EQ(refusal([&] { rasterise(behind, 4, 4); }), "mesh: a vertex is not in front of the camera");
  const Mesh infinite{1, 1, {{0, 0, 1}, {std::numeric_limits<double>::infinity(), 0, 1}, {0, 1, 1}, {1, 1, 1}}};
  EXPECT_EQ(refusal([&] { rasterise(infinite, 4, 4); }), "mesh: a vertex is not in front of the camera");
  EXPECT_EQ(refusal([] { rasterise(scene_mesh(find_scene("text")), 0, 4); }), "mesh: 0 x 4 pixels");
}

// Either winding is taken.
TEST(mesh, a_mirrored_mesh_is_covered) {
  const Mesh mirrored{1, 1, {{1, 0, 1}, {0, 0, 2}, {1, 1, 1}, {0, 1, 2}}};
  for_each_fragment(mirrored, 5, 3, [&](const Fragment& fragment, double x, double) {
    const double one_over_w = 0.5 + 0.5 * x;  // linear in screen space
    EXPECT_NEAR(interpolate(fragment, [&](std::size_t i) { return mirrored.vertices[i].w; }), 1 / one_over_w, 1e-12);
  });
}

}  // namespace
}  // namespace feline
