// SPDX-License-Identifier: Apache-2.0
// The model's side of the leaves of group, footprint and plan.
#include "model/footprint.h"
#include "model/group.h"
#include "model/plan.h"
#include "testbench/prove/lane_loop.h"
#include "testbench/prove/leaves.h"
#include "testbench/prove/set_field.h"

namespace feline::prove {
namespace {

using Sampler = SamplerState<kUnit>;

Sampler sampler_of_mode(std::int64_t mode) {
  Sampler sampler;
  set(sampler.mode, mode);
  set(sampler.length_factor, UnitFormats::kFactor.one());
  return sampler;
}

}  // namespace

Position::Outputs Position::model(const Inputs& inputs) {
  const auto [wrap, bits] = inputs;
  const FloatParts parts = float_parts(bits);
  const Wrap supported = supported_wrap(kUnit.features, static_cast<Wrap>(wrap));
  constexpr int kFullRange = std::max(UnitFormats::kSaturationLog2, kFullRangeLog2);
  const bool beyond = reaches(parts, supported, kFullRange);
  return {to_position<kUnit>(parts, supported).raw(), parts.finite(), parts.finite() && beyond,
          reaches(parts, supported, UnitFormats::kSaturationLog2) && !beyond};
}

Align::Outputs Align::model(const Inputs& inputs) {
  const auto [mode, width, height, dsdx, dtdx, dsdy, dtdy] = inputs;
  Sampler sampler = sampler_of_mode(mode);
  set(sampler.width, width);
  set(sampler.height, height);
  RequestBeat<kUnit> request;
  set(request.dsdx, dsdx);
  set(request.dtdx, dtdx);
  set(request.dsdy, dsdy);
  set(request.dtdy, dtdy);
  const GroupBeat<kUnit> beat = group<kUnit>(request, sampler);
  return {beat.status.raw(), beat.exponent.raw(), beat.dudx.raw(), beat.dvdx.raw(), beat.dudy.raw(), beat.dvdy.raw()};
}

Footprint::Outputs Footprint::model(const Inputs& inputs) {
  const auto [mode, dudx, dvdx, dudy, dvdy] = inputs;
  GroupBeat<kUnit> group;
  set(group.dudx, dudx);
  set(group.dvdx, dvdx);
  set(group.dudy, dudy);
  set(group.dvdy, dvdy);
  Sampler sampler;
  set(sampler.mode, mode);
  const FootprintBeat<kUnit> beat = footprint<kUnit>(group, sampler);
  return {beat.major_u.raw(), beat.major_v.raw(), beat.major_radius.raw(), beat.minor_radius.raw()};
}

ClampRadii::Outputs ClampRadii::model(const Inputs& inputs) {
  const auto [mode, length_factor, exponent, major_radius, minor_radius] = inputs;
  FootprintBeat<kUnit> footprint;
  set(footprint.exponent, exponent);
  set(footprint.major_radius, major_radius);
  set(footprint.minor_radius, minor_radius);
  const ClampedRadii radii = clamp_radii<kUnit>(footprint, static_cast<Mode>(mode), length_factor);
  return {radii.magnified, radii.major, radii.minor};
}

WantedProbes::Outputs WantedProbes::model(const Inputs& inputs) {
  const auto [mode, probe_rounding, probe_factor, major, minor] = inputs;
  if (minor == 0) return {kWanted.max_raw(), kEighths.max_raw()};
  Sampler sampler;
  set(sampler.probe_rounding, probe_rounding);
  set(sampler.probe_factor, probe_factor);
  const std::int64_t wanted = wanted_probes<kUnit>({false, major, minor}, static_cast<Mode>(mode), sampler);
  // The model does not saturate: what the RTL cannot hold is more than any limit.
  return {std::min(wanted, kWanted.max_raw()), std::min(eighths_of({false, major, minor}), kEighths.max_raw())};
}

ChooseProbes::Outputs ChooseProbes::model(const Inputs& inputs) {
  const auto [magnified, max_probes, wanted] = inputs;
  Sampler sampler;
  set(sampler.max_probes, max_probes);
  const ProbeChoice choice =
      choose_probes<kUnit>({magnified != 0, wanted << kMinorLog2, std::int64_t{1} << kMinorLog2}, Mode::kExt, sampler);
  return {choice.probes, choice.limited};
}

FitRadius::Outputs FitRadius::model(const Inputs& inputs) {
  const auto [mode, probe_rounding, blur_factor, inverse_alias, limited, probes, major, minor] = inputs;
  Sampler sampler;
  set(sampler.probe_rounding, probe_rounding);
  set(sampler.blur_factor, blur_factor);
  set(sampler.inverse_alias_factor, inverse_alias);
  return {fit_minor_radius<kUnit>({false, major, minor}, static_cast<Mode>(mode), {probes, limited != 0}, sampler)};
}

LevelOfRadius::Outputs LevelOfRadius::model(const Inputs& inputs) {
  const auto [exponent, radius] = inputs;
  return {level_of_radius<kUnit>(radius, exponent).raw()};
}

SampledLevel::Outputs SampledLevel::model(const Inputs& inputs) {
  const auto [mode, magnify, levels_cut, last_level, min_level, max_level, level_bias, base_level] = inputs;
  Sampler sampler = sampler_of_mode(mode);
  set(sampler.magnify, magnify);
  set(sampler.levels_cut, levels_cut);
  set(sampler.last_level, last_level);
  set(sampler.min_level, min_level);
  set(sampler.max_level, max_level);
  set(sampler.level_bias, level_bias);
  const LevelChoice choice = choose_level<kUnit>(base_level, static_cast<Mode>(mode), sampler);
  return {choice.level_of_detail, choice.linear, choice.missing};
}

LineFraction::Outputs LineFraction::model(const Inputs& inputs) {
  const auto [fitted, major, major_radius] = inputs;
  return {line_fraction<kUnit>(major, fitted, major_radius)};
}

HalfStepFactor::Outputs HalfStepFactor::model(const Inputs& inputs) {
  const auto [mode, probes, line] = inputs;
  return {half_step_factor<kUnit>(static_cast<Mode>(mode), probes, line)};
}

TextureProduct::Outputs TextureProduct::model(const Inputs& inputs) {
  const auto [reciprocal, vector] = inputs;
  // The model has it within to_half_step; with this exponent no bit of it is dropped.
  constexpr int kExponent =
      F::kVector.fraction_bits + F::kReciprocal.fraction_bits + F::kSizeReciprocal.fraction_bits - F::kPositionFraction;
  return {to_half_step<kUnit>(vector, 1, reciprocal, 0, kExponent).raw()};
}

HalfStep::Outputs HalfStep::model(const Inputs& inputs) {
  const auto [product, factor, size_shift, exponent] = inputs;
  return {to_half_step<kUnit>(product, factor, 1, size_shift, exponent).raw()};
}

WeightRow::Outputs WeightRow::model(const Inputs& inputs) {
  const auto [mode, probes, eighths] = inputs;
  // Radii whose quotient it is.
  return {choose_weight_row<kUnit>({false, eighths, 8}, static_cast<Mode>(mode), probes)};
}

template void evaluate_model<Position>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<Align>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<Footprint>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<ClampRadii>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<WantedProbes>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<ChooseProbes>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<FitRadius>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<LevelOfRadius>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<SampledLevel>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<LineFraction>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<HalfStepFactor>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<TextureProduct>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<HalfStep>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<WeightRow>(const std::uint64_t*, std::uint64_t*, std::size_t);

}  // namespace feline::prove
