// SPDX-License-Identifier: Apache-2.0
#include "testbench/scenes/builtin.h"
#include "testbench/scenes/ground.h"
#include "testbench/scenes/mesh.h"

namespace feline {
namespace {

constexpr GroundView kView = {.top = 0.10,
                              .bottom = 0.80,
                              .width = 0.7,
                              .cosine = 4.0 / 5.0,
                              .sine = 3.0 / 5.0,
                              .scale = 0.6,
                              .s_offset = 0.0,
                              .t_offset = -0.1};

// The inverse of ground_point, as a vertex.
constexpr MeshVertex ground_vertex(double s, double t) {
  const double along_s = (s - kView.s_offset) / kView.scale;
  const double along_t = (t - kView.t_offset) / kView.scale;
  const double side = kView.cosine * along_s + kView.sine * along_t;
  const double ahead = kView.sine * along_s - kView.cosine * along_t;
  return {0.5 + side / (kView.width * ahead), (1.0 / ahead - kView.top) / (kView.bottom - kView.top), ahead};
}

// Squares of half a texture repeat. Texture coordinates in the picture are 0.24 to 5.28 and -6.16 to -0.54;
// the camera is above (0, -0.1), and all squares are ahead of it.
Mesh tessellated_mesh() {
  constexpr double kSquare = 0.5;
  Mesh mesh{11, 12, {}};
  for (int row = 0; row <= mesh.rows; ++row) {
    for (int column = 0; column <= mesh.columns; ++column) {
      mesh.vertices.push_back(ground_vertex(kSquare * column, -6.5 + kSquare * row));
    }
  }
  return mesh;
}

TexturePoint project_tessellated(const Dual& x, const Dual& y) { return ground_point(kView, x, y); }

}  // namespace

Scene tessellated_scene() {
  return {"tessellated",
          "concentric arcs on a plane of large polygons, turned: a mesh for filters that decide by vertex",
          TexelFormat::kRgba8,
          false,
          paint_curves,
          project_tessellated,
          {},
          tessellated_mesh};
}

}  // namespace feline
