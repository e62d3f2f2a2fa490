// SPDX-License-Identifier: Apache-2.0
#include "model/reference/feline.h"

#include <algorithm>
#include <cmath>

namespace feline::reference {
namespace {

struct Fit {
  int probes;
  double minor_radius;
};

// 3.1: nearest; a line with too few probes is widened to what they cover.
Fit fit_nearest(double major, double minor, const FelineParameters& parameters) {
  const double wanted = 2 * major / minor - 1;
  const int probes = static_cast<int>(std::min(std::floor(wanted + 0.5), double(parameters.max_probes)));
  return {probes, probes < wanted ? 2 * major / (probes + 1) : minor};
}

// 3.4: as few as blurring by blur_factor and spreading by alias_factor allow.
Fit fit_ceiling(double major, double minor, const FelineParameters& parameters) {
  const double factor = 1 / (parameters.blur_factor * parameters.alias_factor);
  const double wanted = std::max(std::ceil(factor * 2 * major / minor) - 1, 1.0);
  if (wanted > parameters.max_probes) {
    return {parameters.max_probes, 2 * major / ((parameters.max_probes + 1) * parameters.alias_factor)};
  }
  return {static_cast<int>(wanted), std::min(2 * major / (wanted + 1), minor * parameters.blur_factor)};
}

}  // namespace

ProbeLine plan_feline(const Axes<double>& axes, const FelineParameters& parameters, double smallest_level) {
  const double minor = std::max(axes.minor_radius, 1.0);
  const double major = std::max(axes.major_radius * parameters.length_factor, minor);
  if (axes.major_radius <= 1) return {};
  const Fit fit = parameters.ceiling ? fit_ceiling(major, minor, parameters) : fit_nearest(major, minor, parameters);
  ProbeLine line;
  line.level_of_detail = std::log2(fit.minor_radius);
  if (line.level_of_detail > smallest_level) {
    line.level_of_detail = smallest_level;
    return line;
  }
  line.probes = fit.probes;
  if (line.probes == 1) return line;
  const double step = 2 * (major - fit.minor_radius) / (line.probes - 1);
  line.step = (step / axes.major_radius) * axes.major;
  // exp(-2 d^2), d in major radii.
  line.falloff = 2 * (step / major) * (step / major);
  return line;
}

Colour feline_filter(const MipMap& map, AxesFunction axes, const FelineParameters& parameters, ProbeKernel kernel,
                     const Lookup& lookup, Cost& cost) {
  const ProbeLine line = plan_feline(axes(in_texels(lookup.gradients, map.base())), parameters, map.smallest_level());
  return sample_line(map, kernel, line, lookup.position, cost);
}

Colour feline_circles_filter(const MipMap& map, const FelineParameters& parameters, const Lookup& lookup, Cost& cost) {
  const Axes<double> axes = ellipse_axes(in_texels(lookup.gradients, map.base()));
  return sample_line_of_circles(map, plan_feline(axes, parameters, map.smallest_level()), lookup.position, cost);
}

}  // namespace feline::reference
