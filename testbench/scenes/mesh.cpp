// SPDX-License-Identifier: Apache-2.0
#include "testbench/scenes/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace feline {
namespace {

constexpr std::int32_t kNone = -1;

Mesh uniform_mesh() {
  constexpr int kSide = 16;
  Mesh mesh{kSide, kSide, {}};
  for (int row = 0; row <= kSide; ++row) {
    for (int column = 0; column <= kSide; ++column) {
      mesh.vertices.push_back({1.0 * column / kSide, 1.0 * row / kSide, 1.0});
    }
  }
  return mesh;
}

void check(const Mesh& mesh) {
  if (mesh.columns < 1 || mesh.rows < 1 ||
      mesh.vertices.size() !=
          (static_cast<std::size_t>(mesh.columns) + 1) * (static_cast<std::size_t>(mesh.rows) + 1)) {
    throw std::invalid_argument(
        fmt::format("mesh: {} vertices for {} x {} quads", mesh.vertices.size(), mesh.columns, mesh.rows));
  }
  const auto usable = [](const MeshVertex& v) { return std::isfinite(v.x) && std::isfinite(v.y) && v.w > 0; };
  if (!std::ranges::all_of(mesh.vertices, usable)) {
    throw std::invalid_argument("mesh: a vertex is not in front of the camera");
  }
}

class Rasteriser {
 public:
  Rasteriser(const Mesh& mesh, int width, int height)
      : mesh_(mesh),
        width_(width),
        height_(height),
        fragments_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Fragment{kNone, {}, {}}) {}

  void triangle(std::int32_t quad, const std::array<std::int32_t, 3>& vertices) {
    const auto [left, right] = std::minmax({at(vertices[0]).x, at(vertices[1]).x, at(vertices[2]).x});
    const auto [top, bottom] = std::minmax({at(vertices[0]).y, at(vertices[1]).y, at(vertices[2]).y});
    const int last_row = last_centre(bottom, height_);
    const int last_column = last_centre(right, width_);
    for (int row = first_centre(top, height_); row <= last_row; ++row) {
      for (int column = first_centre(left, width_); column <= last_column; ++column) {
        Fragment& fragment = fragments_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                        static_cast<std::size_t>(column)];
        if (fragment.quad == kNone) cover(fragment, quad, vertices, (column + 0.5) / width_, (row + 0.5) / height_);
      }
    }
  }

  std::vector<Fragment> finish() && {
    const auto hole = std::ranges::find(fragments_, kNone, &Fragment::quad);
    if (hole != fragments_.end()) {
      const auto pixel = hole - fragments_.begin();
      throw std::invalid_argument(fmt::format("mesh: pixel {}, {} is not covered", pixel % width_, pixel / width_));
    }
    return std::move(fragments_);
  }

 private:
  const MeshVertex& at(std::int32_t index) const { return mesh_.vertices[static_cast<std::size_t>(index)]; }

  // The first and last pixel whose centre may be beyond an edge of a box; one more on either side, since
  // the box only saves work. Clamped in double, as a vertex may be anywhere.
  static int first_centre(double low, int size) {
    return static_cast<int>(std::clamp(std::floor(low * size - 0.5), 0.0, 1.0 * size));
  }
  static int last_centre(double high, int size) {
    return static_cast<int>(std::clamp(std::ceil(high * size - 0.5), -1.0, size - 1.0));
  }

  // Twice the signed area of the triangle from, to, (x, y). The lower vertex is always first in the
  // arithmetic, so that both triangles at an edge see exact opposites and leave no gap.
  double edge(std::int32_t from, std::int32_t to, double x, double y) const {
    if (from > to) return -edge(to, from, x, y);
    return (at(to).x - at(from).x) * (y - at(from).y) - (at(to).y - at(from).y) * (x - at(from).x);
  }

  void cover(Fragment& fragment, std::int32_t quad, const std::array<std::int32_t, 3>& vertices, double x,
             double y) const {
    const std::array<double, 3> areas = {edge(vertices[1], vertices[2], x, y), edge(vertices[2], vertices[0], x, y),
                                         edge(vertices[0], vertices[1], x, y)};
    const auto [least, most] = std::ranges::minmax(areas);
    if (least < 0 && most > 0) return;
    std::array<double, 3> weights{};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      weights[i] = areas[i] / at(vertices[i]).w;
      sum += weights[i];
    }
    if (sum == 0) return;  // the vertices are in line
    for (double& weight : weights) weight /= sum;
    fragment = {quad, vertices, weights};
  }

  const Mesh& mesh_;
  int width_;
  int height_;
  std::vector<Fragment> fragments_;
};

}  // namespace

Mesh scene_mesh(const Scene& scene) { return scene.mesh == nullptr ? uniform_mesh() : scene.mesh(); }

std::vector<Fragment> rasterise(const Mesh& mesh, int width, int height) {
  check(mesh);
  if (width < 1 || height < 1) throw std::invalid_argument(fmt::format("mesh: {} x {} pixels", width, height));
  Rasteriser rasteriser(mesh, width, height);
  for (std::int32_t row = 0; row < mesh.rows; ++row) {
    for (std::int32_t column = 0; column < mesh.columns; ++column) {
      const std::int32_t quad = row * mesh.columns + column;
      const std::int32_t above = row * (mesh.columns + 1) + column;
      const std::int32_t below = above + mesh.columns + 1;
      rasteriser.triangle(quad, {above, above + 1, below + 1});
      rasteriser.triangle(quad, {above, below + 1, below});
    }
  }
  return std::move(rasteriser).finish();
}

std::vector<TexturePoint> vertex_points(const Scene& scene, const Mesh& mesh) {
  std::vector<TexturePoint> points;
  points.reserve(mesh.vertices.size());
  for (const MeshVertex& vertex : mesh.vertices) {
    points.push_back(scene.project(Dual(vertex.x, 1.0, 0.0), Dual(vertex.y, 0.0, 1.0)));
  }
  return points;
}

}  // namespace feline
