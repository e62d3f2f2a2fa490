// SPDX-License-Identifier: Apache-2.0
#include "testbench/figures/viewing_angles.h"

#include <cmath>
#include <numbers>

#include "model/reference/approximate_axes.h"
#include "model/reference/ewa.h"
#include "model/reference/feline.h"
#include "model/reference/isotropic.h"
#include "model/reference/texram.h"

namespace feline {
namespace {

using reference::Vector2;

constexpr double kHalfField = 2.4 * std::numbers::pi / 180;  // at 85 degrees every ray still meets the plane
constexpr int kTexture = 256;
constexpr int kPixels = 8;  // a side of the picture
constexpr int kDistances = 16;
constexpr int kTurns = 8;
constexpr int kMostProbes = 16;
// Far from the clamp of radii at a texel and from the end of the mip levels; and where EWA changes levels, so that few
// distances are enough for the mean.
constexpr double kLeastRadius = 6;

// What is in the texels does not matter to costs.
reference::MipMap blank_texture() {
  reference::MipMap map;
  for (int size = kTexture; size > 0; size /= 2) {
    const auto texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    map.levels.push_back({size, size, std::vector<reference::Texel>(texels)});
  }
  return map;
}

// Evenly over a square of 32 texels, in which lookups meet every place among the texels and stamps of the levels that
// are read (Roberts' sequence, 2018).
Vector2<double> scatter(int index) {
  constexpr double kSquare = 32.0 / kTexture;
  const auto part = [&](double step) { return kSquare * std::fmod(step * index, 1.0); };
  return {part(0.7548776662466927), part(0.5698402909980532)};
}

void add(reference::Cost& sum, const reference::Cost& cost, double weight) {
  sum.probes += weight * cost.probes;
  sum.texels += weight * cost.texels;
  sum.cycles += weight * cost.cycles;
  sum.stamp_cycles += weight * cost.stamp_cycles;
}

}  // namespace

std::vector<reference::Lookup> plane_lookups(double degrees, double radius, double turn, int side, int texture_size) {
  const double angle = degrees * std::numbers::pi / 180;
  const double pixel = 2 * std::tan(kHalfField) / side;  // on the picture plane at distance 1
  // The plane, at distance 1 along the line of sight, is tilted about the horizontal: the ray (x, y, 1) meets it at
  // depth z = cos / (cos - y sin), x z from the middle across and y z / cos along the slope.
  const double scale = radius / pixel;  // texels a unit of the plane
  std::vector<reference::Lookup> lookups;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = pixel * (column + 0.5 - side / 2.0);
      const double y = pixel * (row + 0.5 - side / 2.0);
      const double depth = std::cos(angle) / (std::cos(angle) - y * std::sin(angle));
      const double slope = depth * depth * std::tan(angle);  // of depth by y
      const auto on_texture = [&](double across, double along) {
        const double factor = scale / texture_size;
        return Vector2<double>{factor * (std::cos(turn) * across - std::sin(turn) * along),
                               factor * (std::sin(turn) * across + std::cos(turn) * along)};
      };
      lookups.push_back({on_texture(x * depth, y * depth / std::cos(angle)),
                         {on_texture(pixel * depth, 0),
                          on_texture(pixel * x * slope, pixel * (depth + y * slope) / std::cos(angle))}});
    }
  }
  return lookups;
}

AngleCosts measure_costs(double degrees) {
  static const reference::MipMap map = blank_texture();
  AngleCosts costs{degrees, {}, {}, {}, {}, {}};
  const double weight = 1.0 / (kDistances * kTurns * kPixels * kPixels);
  int count = 0;
  for (int i = 0; i < kDistances * kTurns; ++i) {
    const int distance = i / kTurns;
    const double radius = kLeastRadius * std::exp2((distance + 0.5) / kDistances);
    // Over half a turn, after which texels and stamps look the same again.
    const double turn = std::numbers::pi * (i % kTurns + 0.5) / kTurns;
    for (reference::Lookup lookup : plane_lookups(degrees, radius, turn, kPixels, kTexture)) {
      lookup.position = lookup.position + scatter(count++);
      const auto measure = [&](reference::Cost& sum, auto&& filter) {
        reference::Cost cost;
        filter(cost);
        add(sum, cost, weight);
      };
      const auto simple = [&](reference::Cost& cost, const reference::FelineParameters& parameters) {
        feline_filter(map, reference::simple_axes, parameters, reference::ProbeKernel::kGaussian, lookup, cost);
      };
      measure(costs.trilinear, [&](auto& cost) { trilinear_filter(map, lookup, cost); });
      measure(costs.texram, [&](auto& cost) { texram_filter(map, kMostProbes, lookup, cost); });
      measure(costs.high_efficiency, [&](auto& cost) { simple(cost, reference::kHighEfficiency); });
      measure(costs.high_quality, [&](auto& cost) { simple(cost, reference::kHighQuality); });
      measure(costs.ewa, [&](auto& cost) { ewa_filter(map, {}, lookup, cost); });
    }
  }
  return costs;
}

}  // namespace feline
