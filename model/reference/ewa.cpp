// SPDX-License-Identifier: Apache-2.0
#include "model/reference/ewa.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/reference/ellipse.h"

namespace feline::reference {
namespace {

constexpr double kLeastMinorRadius = 1.5;  // texels of the level that is read, and twice that is the most
constexpr double kMostRadius = 48;
constexpr double kMostTexelsOfBase = 1 << 18;

int choose_level(const MipMap& map, double minor_radius) {
  if (minor_radius < 2 * kLeastMinorRadius) return 0;
  const double level = std::floor(std::log2(minor_radius / kLeastMinorRadius));
  return static_cast<int>(std::min(level, static_cast<double>(map.last_level())));
}

// So much of an ellipse that reading it takes a bounded time.
struct Radii {
  double major;
  double minor;
};

Radii limit_radii(double major, double minor, int level) {
  if (level > 0) return {std::min(major, kMostRadius), std::min(minor, kMostRadius)};
  constexpr double kMostArea = kMostTexelsOfBase / std::numbers::pi;
  if (major * minor <= kMostArea) return {major, minor};
  const double limited = std::min(minor, std::sqrt(kMostArea));
  return {kMostArea / limited, limited};
}

// Into one period; a clamped coordinate so far out that every texel there is the same stays out, and fits an integer.
double near_texture(double coordinate, Wrap wrap) {
  constexpr double kFar = 1 << 20;
  switch (wrap) {
    case Wrap::kRepeat: return coordinate - std::floor(coordinate);
    case Wrap::kMirroredRepeat: return coordinate - 2 * std::floor(coordinate / 2);
    case Wrap::kClampToEdge:
    case Wrap::kClampToBorder: return std::clamp(coordinate, -kFar, kFar);
  }
  return coordinate;
}

// The columns of a row inside the ellipse: u with a u^2 + b u v + c v^2 <= 1.
struct Chord {
  double middle;
  double half;  // < 0: none
};

Chord chord(const EwaEllipse& ellipse, double v) {
  const double middle = -ellipse.b * v / (2 * ellipse.a);
  const double square = middle * middle - (ellipse.c * v * v - 1) / ellipse.a;
  return {middle, square < 0 ? -1 : std::sqrt(square)};
}

// Counts the stamps of "Realistic EWA" that rows of texels touch.
class Stamps {
 public:
  explicit Stamps(bool wide) : across_(wide ? 4 : 2), down_(wide ? 2 : 4) {}
  void row(std::int64_t y, std::int64_t first, std::int64_t last) {
    const auto cell = [](std::int64_t at, std::int64_t size) { return (at >= 0 ? at : at - size + 1) / size; };
    if (cell(y, down_) != stamp_row_) {
      finish();
      stamp_row_ = cell(y, down_);
    }
    first_ = empty_ ? cell(first, across_) : std::min(first_, cell(first, across_));
    last_ = empty_ ? cell(last, across_) : std::max(last_, cell(last, across_));
    empty_ = false;
  }
  double finish() {
    if (!empty_) count_ += static_cast<double>(last_ - first_ + 1);
    empty_ = true;
    return count_;
  }

 private:
  std::int64_t across_, down_;
  std::int64_t stamp_row_ = 0, first_ = 0, last_ = 0;
  bool empty_ = true;
  double count_ = 0;
};

}  // namespace

EwaEllipse plan_ewa(const MipMap& map, const EwaParameters& parameters, const Gradients<double>& normalized) {
  const auto bounded_minor = [&](const Axes<double>& axes) {
    return parameters.max_eccentricity == 0
               ? axes.minor_radius
               : std::max(axes.minor_radius, axes.major_radius / parameters.max_eccentricity);
  };
  EwaEllipse ellipse;
  if (parameters.mip_mapped) {
    ellipse.level = choose_level(map, bounded_minor(ellipse_axes(in_texels(normalized, map.base()))));
  }
  const Axes<double> axes = ellipse_axes(in_texels(normalized, map.levels[static_cast<std::size_t>(ellipse.level)]));
  const double widen = ellipse.level == 0 && parameters.reconstructs ? 1 : 0;
  const auto [major, minor] =
      limit_radii(std::hypot(axes.major_radius, widen), std::hypot(bounded_minor(axes), widen), ellipse.level);
  const double cosine = axes.major_radius == 0 ? 1 : axes.major.u / axes.major_radius;
  const double sine = axes.major_radius == 0 ? 0 : axes.major.v / axes.major_radius;
  const double along = 1 / (major * major);
  const double across = 1 / (minor * minor);
  ellipse.a = cosine * cosine * along + sine * sine * across;
  ellipse.b = 2 * cosine * sine * (along - across);
  ellipse.c = sine * sine * along + cosine * cosine * across;
  ellipse.half_width = std::hypot(major * cosine, minor * sine);
  ellipse.half_height = std::hypot(major * sine, minor * cosine);
  return ellipse;
}

Colour ewa_filter(const MipMap& map, const EwaParameters& parameters, const Lookup& lookup, Cost& cost) {
  const EwaEllipse ellipse = plan_ewa(map, parameters, lookup.gradients);
  const Level& level = map.levels[static_cast<std::size_t>(ellipse.level)];
  const double u = near_texture(lookup.position.u, map.wrapping.s) * level.width - 0.5;
  const double v = near_texture(lookup.position.v, map.wrapping.t) * level.height - 0.5;
  Colour sum{};
  double weights = 0;
  double texels = 0;
  Stamps stamps(ellipse.half_width >= ellipse.half_height);
  const auto last_row = static_cast<std::int64_t>(std::floor(v + ellipse.half_height));
  for (auto y = static_cast<std::int64_t>(std::ceil(v - ellipse.half_height)); y <= last_row; ++y) {
    const double dv = static_cast<double>(y) - v;
    const Chord inside = chord(ellipse, dv);
    const auto first = static_cast<std::int64_t>(std::ceil(u + inside.middle - inside.half));
    const auto last = static_cast<std::int64_t>(std::floor(u + inside.middle + inside.half));
    if (inside.half < 0 || first > last) continue;
    stamps.row(y, first, last);
    for (std::int64_t x = first; x <= last; ++x) {
      const double du = static_cast<double>(x) - u;
      const double weight = std::exp(-2 * (ellipse.a * du * du + ellipse.b * du * dv + ellipse.c * dv * dv));
      add_weighted(sum, weight, wrapped_texel(level, map.wrapping, x, y));
      weights += weight;
    }
    texels += static_cast<double>(last - first + 1);
  }
  if (weights == 0) {
    cost.add(1, 4, 1);
    return two_by_two(level, map.wrapping, ProbeKernel::kBilinear, lookup.position.u, lookup.position.v);
  }
  cost.probes += 1;
  cost.texels += texels;
  cost.cycles += std::ceil(texels / 8);
  cost.stamp_cycles += stamps.finish();
  for (double& channel : sum) channel /= weights;
  return sum;
}

}  // namespace feline::reference
