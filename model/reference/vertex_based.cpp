// SPDX-License-Identifier: Apache-2.0
#include "model/reference/vertex_based.h"

#include <cmath>
#include <numeric>

#include "model/reference/ellipse.h"
#include "model/reference/isotropic.h"

namespace feline::reference {
namespace {

// As Feline sets its probes: the ends a spacing inside the circle.
double position(int index, int count) { return 2.0 * (index + 1) / (count + 1) - 1; }

ProbePattern weighted(std::vector<Vector2<double>> probes, double spacing) {
  ProbePattern pattern{std::move(probes), {}, spacing};
  for (const auto& probe : pattern.probes)
    pattern.weights.push_back(std::exp(-2 * (probe.u * probe.u + probe.v * probe.v)));
  const double sum = std::accumulate(pattern.weights.begin(), pattern.weights.end(), 0.0);
  for (double& weight : pattern.weights) weight /= sum;
  return pattern;
}

}  // namespace

Gradients<double> vertex_axes(AxisSystem system, const Gradients<double>& normalized_gradients, const Level& base) {
  const Gradients<double> texels = in_texels(normalized_gradients, base);
  switch (system) {
    case AxisSystem::kEllipse: {
      const Axes<double> axes = ellipse_axes(texels);
      const double ratio = axes.major_radius == 0 ? 0 : axes.minor_radius / axes.major_radius;
      return {normalized(axes.major, base), normalized({-ratio * axes.major.v, ratio * axes.major.u}, base)};
    }
    case AxisSystem::kScreen: return normalized_gradients;
    case AxisSystem::kMax:
      if (length(texels.x) > length(texels.y)) return normalized_gradients;
      return {normalized_gradients.y, normalized_gradients.x};
  }
  return normalized_gradients;
}

ProbePattern line_pattern(int probes) {
  std::vector<Vector2<double>> places;
  for (int i = 0; i < probes; ++i) places.push_back({position(i, probes), 0});
  return weighted(std::move(places), 2.0 / (probes + 1));
}

ProbePattern square_pattern(int side_probes) {
  std::vector<Vector2<double>> places;
  for (int j = 0; j < side_probes; ++j) {
    for (int i = 0; i < side_probes; ++i) places.push_back({position(i, side_probes), position(j, side_probes)});
  }
  return weighted(std::move(places), 2.0 / (side_probes + 1));
}

ProbePattern staggered_pattern() {
  return weighted({{-0.5, -0.5}, {0, -0.5}, {0.5, -0.5}, {-0.25, 0}, {0.25, 0}, {-0.5, 0.5}, {0, 0.5}, {0.5, 0.5}},
                  0.5);
}

std::vector<double> blend_alphas(std::span<const double> weights) {
  std::vector<double> alphas(weights.size());
  double remaining = 1;
  for (std::size_t k = weights.size(); k-- > 0;) {
    alphas[k] = k == 0 ? 1 : weights[k] / remaining;
    remaining *= 1 - alphas[k];
  }
  return alphas;
}

Colour vertex_based_filter(const MipMap& map, const ProbePattern& pattern, std::span<const double> alphas,
                           const Gradients<double>& axes, const Lookup& lookup, Cost& cost) {
  const double level = isotropic_level(map, lookup) + std::log2(pattern.spacing);
  Colour frame{};
  for (std::size_t k = 0; k < pattern.probes.size(); ++k) {
    const Vector2<double> at = lookup.position + pattern.probes[k].u * axes.x + pattern.probes[k].v * axes.y;
    const Colour probe = mip_probe(map, ProbeKernel::kBilinear, level, at.u, at.v, cost);
    for (double& channel : frame) channel *= 1 - alphas[k];
    add_weighted(frame, alphas[k], probe);
  }
  return frame;
}

}  // namespace feline::reference
