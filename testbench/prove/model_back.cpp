// SPDX-License-Identifier: Apache-2.0
// The model's side of the leaves of walk, address, fetch, filter and accumulate.
#include "model/accumulate.h"
#include "model/address.h"
#include "model/fetch.h"
#include "model/filter.h"
#include "model/walk.h"
#include "testbench/prove/lane_loop.h"
#include "testbench/prove/leaves.h"
#include "testbench/prove/set_field.h"

namespace feline::prove {
ProbeWeight::Outputs ProbeWeight::model(const Inputs& inputs) {
  const auto [probes, weight_row, probe] = inputs;
  const std::int64_t n = probe_offset(probe, probes);
  return {n, probe_weight<kUnit>(weight_row, n), kUnit.weight_rows.has(static_cast<std::size_t>(weight_row))};
}

ProbePosition::Outputs ProbePosition::model(const Inputs& inputs) {
  const auto [centre, half_step, n] = inputs;
  return {probe_position<kUnit>(centre, half_step, n).raw()};
}

LevelSize::Outputs LevelSize::model(const Inputs& inputs) {
  const auto [size, level] = inputs;
  return {level_size(size, level)};
}

AxisTexels::Outputs AxisTexels::model(const Inputs& inputs) {
  const auto [wrap, linear, size, position] = inputs;
  const Wrap supported = supported_wrap(kUnit.features, static_cast<Wrap>(wrap));
  const feline::AxisTexels texels = axis_texels<kUnit>(position, size, supported, linear != 0);
  return {texels.index[1], texels.index[0], (texels.outside[0] ? 1 : 0) | (texels.outside[1] ? 2 : 0), texels.fraction};
}

LevelLines::Outputs LevelLines::model(const Inputs& inputs) {
  const auto [x_1, x_0, y_1, y_0, width, base] = inputs;
  const LevelShape shape{width, 0, tiles_a_row(width), base};
  return {shape.line(x_1, y_1), shape.line(x_0, y_1), shape.line(x_1, y_0), shape.line(x_0, y_0)};
}

DecodeTexel::Outputs DecodeTexel::model(const Inputs& inputs) {
  const auto [texel_format, srgb, column, word] = inputs;
  SamplerState<kUnit> sampler;
  set(sampler.texel_format, texel_format);
  set(sampler.srgb, srgb);
  // A line that holds the word wherever a word can be.
  std::array<std::uint8_t, std::size_t{4} * kTileSide * kTileSide> line{};
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = static_cast<std::uint8_t>(word >> (8 * (i % 4)));
  const auto texel = decode_texel<kUnit>(line, column, 0, sampler);
  return {texel[3].raw(), texel[2].raw(), texel[1].raw(), texel[0].raw()};
}

KernelWeight::Outputs KernelWeight::model(const Inputs& inputs) {
  const auto [fraction] = inputs;
  return {kernel_weight<kUnit>(fraction, true)};
}

InterpolateTexels::Outputs InterpolateTexels::model(const Inputs& inputs) {
  const auto [a, b, fraction] = inputs;
  return {interpolate(a, b, fraction, kUnit.subtexel_bits)};
}

FilterTexels::Outputs FilterTexels::model(const Inputs& inputs) {
  const auto [kernel, linear, level_fraction, fine_x, fine_y, coarse_x, coarse_y, fine_00, fine_10, fine_01, fine_11,
              coarse_00, coarse_10, coarse_01, coarse_11] = inputs;
  SamplerState<kUnit> sampler;
  set(sampler.kernel, kernel);
  FetchBeat<kUnit> fetch;
  set(fetch.linear, linear);
  set(fetch.level_fraction, level_fraction);
  set(fetch.fine_fraction_x, fine_x);
  set(fetch.fine_fraction_y, fine_y);
  set(fetch.coarse_fraction_x, coarse_x);
  set(fetch.coarse_fraction_y, coarse_y);
  set(fetch.fine_00[0], fine_00);
  set(fetch.fine_10[0], fine_10);
  set(fetch.fine_01[0], fine_01);
  set(fetch.fine_11[0], fine_11);
  set(fetch.coarse_00[0], coarse_00);
  set(fetch.coarse_10[0], coarse_10);
  set(fetch.coarse_01[0], coarse_01);
  set(fetch.coarse_11[0], coarse_11);
  return {filter<kUnit>(fetch, sampler).colour[0].raw()};
}

WeighColour::Outputs WeighColour::model(const Inputs& inputs) {
  const auto [weight, colour] = inputs;
  FilterBeat<kUnit> filter;
  set(filter.first, 1);
  set(filter.last, 1);
  set(filter.weight, weight);
  set(filter.colour[0], colour);
  Accumulator<kUnit> sum;
  return {accumulate<kUnit>(filter, sum)->colour[0].raw()};
}

template void evaluate_model<ProbeWeight>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<ProbePosition>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<LevelSize>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<AxisTexels>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<LevelLines>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<DecodeTexel>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<KernelWeight>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<InterpolateTexels>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<FilterTexels>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_model<WeighColour>(const std::uint64_t*, std::uint64_t*, std::size_t);

}  // namespace feline::prove
