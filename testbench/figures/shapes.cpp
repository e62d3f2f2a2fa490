// SPDX-License-Identifier: Apache-2.0
#include "testbench/figures/shapes.h"

#include <cmath>
#include <stdexcept>

#include "model/reference/approximate_axes.h"
#include "model/reference/feline.h"
#include "model/reference/lookup.h"
#include "model/reference/texram.h"

namespace feline {
namespace {

using reference::Gradients;
using reference::ProbeKernel;
using reference::ProbeLine;

constexpr int kMaxProbes = 16;
constexpr double kNoSmallestLevel = 1e9;

// The high-efficiency set, but for its length factor: the probes then stand the printed "effectively 1.26" probe radii
// apart; with the set's 0.9625 they stand 1.18 apart.
constexpr reference::FelineParameters kFigure14{true, 1, 1.3125, 1.3544, kMaxProbes};

ProbeLine single_probe(double radius) {
  ProbeLine line;
  line.level_of_detail = std::log2(radius);
  return line;
}

ProbeLine simple(const Gradients<double>& texels, const reference::FelineParameters& parameters) {
  return plan_feline(reference::simple_axes(texels), parameters, kNoSmallestLevel);
}

// As if rounding had gone up: the same line, twice as many probes.
ProbeLine doubled(ProbeLine line) {
  line.probes *= 2;
  line.step = 0.5 * line.step;
  return line;
}

}  // namespace

PlannedShape plan_shape(int figure, const Gradients<double>& texels) {
  switch (figure) {
    case 5: return {single_probe(std::max(length(texels.x), length(texels.y)))};
    case 7: return {plan_texram(texels, kMaxProbes)};
    case 8: return {doubled(plan_texram(texels, kMaxProbes))};
    case 12: return {plan_feline(reference::ellipse_axes(texels), reference::kExact, kNoSmallestLevel)};
    case 13: return {simple(texels, reference::kExact)};
    case 14: return {simple(texels, kFigure14)};
    case 15: return {single_probe(std::sqrt(2))};
    case 16: return {single_probe(std::sqrt(2)), ProbeKernel::kGaussian};
    case 17: return {simple(texels, kFigure14), ProbeKernel::kGaussian};
    default: break;
  }
  throw std::invalid_argument("no figure of a filter's shape");
}

FilterShape impulse_response(const PlannedShape& planned, MipFilter mip_filter, int per_texel) {
  const auto filter = [&](const reference::MipMap& map, const reference::Vector2<double>& texels) {
    reference::Cost cost;
    return sample_line(map, planned.kernel, planned.line, reference::normalized(texels, map.base()), cost);
  };
  const int coarsest = std::max(static_cast<int>(std::ceil(planned.line.level_of_detail)), 0);
  return impulse_response(filter, mip_filter, coarsest, per_texel);
}

}  // namespace feline
