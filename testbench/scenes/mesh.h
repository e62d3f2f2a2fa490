// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "testbench/scenes/scene.h"

namespace feline {

// The polygons of a surface, for filters that decide by vertex or by polygon.

struct MeshVertex {
  double x;  // in pictures, from the upper left corner; beyond [0, 1] outside the picture
  double y;
  double w;  // > 0: in front of the camera
};

// A grid of columns x rows quads. Quad (column, row) is number row * columns + column; its diagonal goes
// from its first vertex, (column, row), to its last, (column + 1, row + 1).
struct Mesh {
  int columns;
  int rows;
  std::vector<MeshVertex> vertices;  // row-major, (columns + 1) * (rows + 1)
};

// The scene's own, or else 16 x 16 equal quads over the picture with w = 1.
Mesh scene_mesh(const Scene& scene);

// What a rasteriser finds at a pixel centre. An attribute of the surface there is the sum of
// weights[i] times its value at vertices[i]: it is the attribute / w that is linear in screen space.
struct Fragment {
  std::int32_t quad;
  std::array<std::int32_t, 3> vertices;
  std::array<double, 3> weights;  // sum to 1
};

// One a pixel, row-major. Of several triangles on a pixel the first one has it; there is no depth.
// Throws std::invalid_argument when the vertices do not fill the grid, when one is not in front of the
// camera, or when a pixel is not covered.
std::vector<Fragment> rasterise(const Mesh& mesh, int width, int height);

// The lookups at the vertices, derivatives per picture.
std::vector<TexturePoint> vertex_points(const Scene& scene, const Mesh& mesh);

}  // namespace feline
