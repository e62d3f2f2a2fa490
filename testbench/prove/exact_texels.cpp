// SPDX-License-Identifier: Apache-2.0
// What the leaves of walk, address, fetch, filter and accumulate must give, stated once more from their contracts:
// whole numbers of the finest unit there is, tables from other means.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "testbench/prove/exact_tables.h"
#include "testbench/prove/lane_loop.h"
#include "testbench/prove/leaves.h"

namespace feline::prove {
namespace {

constexpr std::int64_t kTurn = std::int64_t{1} << 24;

// Twice as many rows and columns as there can be, so that nothing is read past the end.
const std::array<std::array<std::int64_t, 32>, 256>& weights_table() {
  static const std::array<std::array<std::int64_t, 32>, 256> table = [] {
    std::array<std::array<std::int64_t, 32>, 256> weights{};
    const auto& table = oracle::tables().weight;
    for (std::size_t row = 0; row < table.size(); ++row)
      std::copy(table[row].begin(), table[row].end(), weights[row].begin());
    return weights;
  }();
  return table;
}

const std::array<std::int64_t, 256>& gaussian_table() {
  static const std::array<std::int64_t, 256> table = [] {
    std::array<std::int64_t, 256> weights{};
    const auto& table = oracle::tables().gaussian;
    std::copy(table.begin(), table.end(), weights.begin());
    return weights;
  }();
  return table;
}

const std::array<std::int64_t, 256>& linear_of_srgb_table() {
  static const std::array<std::int64_t, 256> table = [] {
    std::array<std::int64_t, 256> linear{};
    const auto& table = oracle::tables().srgb;
    std::copy(table.begin(), table.end(), linear.begin());
    return linear;
  }();
  return table;
}

std::int64_t wrapped_of(std::int64_t position, Wrap wrap) {
  switch (wrap) {
    case Wrap::kRepeat: return position & (kTurn - 1);
    case Wrap::kMirroredRepeat: {
      // Of the way there and the way back from the end of both pictures, the shorter one.
      const std::int64_t there = position & (2 * kTurn - 1);
      return std::min(there, 2 * kTurn - there);
    }
    case Wrap::kClampToEdge: return std::clamp<std::int64_t>(position, 0, kTurn);
    case Wrap::kClampToBorder: return std::clamp(position, -kTurn, 2 * kTurn - 1);
  }
  return 0;
}

}  // namespace

ProbeWeight::Outputs ProbeWeight::exact(const Inputs& inputs) {
  const auto [probes, weight_row, probe] = inputs;
  const std::int64_t n = 2 * probe - (probes - 1);
  const std::int64_t column = (std::abs(n) + 1) / 2;
  return {n, weights_table()[static_cast<std::size_t>(weight_row & 255)][static_cast<std::size_t>(column & 31)], 1};
}

ProbePosition::Outputs ProbePosition::exact(const Inputs& inputs) {
  const auto [centre, half_step, n] = inputs;
  constexpr std::int64_t kTurn = std::int64_t{1} << 45;
  const std::int64_t left = (centre + n * half_step) & (kTurn - 1);
  return {left < kTurn / 2 ? left : left - kTurn};
}

LevelSize::Outputs LevelSize::exact(const Inputs& inputs) {
  const auto [size, level] = inputs;
  const std::int64_t texels = size / (std::int64_t{1} << level);
  return {texels == 0 ? 1 : texels};
}

AxisTexels::Outputs AxisTexels::exact(const Inputs& inputs) {
  const auto [wrap_code, linear, size, position] = inputs;
  const auto wrap = static_cast<Wrap>(wrap_code);
  // In 2^-24 texels, so that a sub-texel is 2^16.
  const std::int64_t place = wrapped_of(position, wrap) * size;
  const std::int64_t subtexels = linear != 0 ? ((place + (1 << 15)) >> 16) - 128 : place >> 24 << 8;
  const std::int64_t first = subtexels >> 8;
  const std::int64_t fraction = subtexels & 255;
  const std::int64_t second = first + 1;
  const std::int64_t last = size - 1;
  if (first >= 0 && first < last) return {second, first, 0, fraction};
  // A repeat goes on at the other end; what clamps stays.
  const bool repeats = wrap == Wrap::kRepeat;
  const std::int64_t before = repeats ? last : 0;
  const std::int64_t after = repeats ? 0 : last;
  const auto inside = [&](std::int64_t index) { return index < 0 ? before : index > last ? after : index; };
  const auto is_outside = [&](std::int64_t index) {
    return wrap == Wrap::kClampToBorder && (index < 0 || index > last) ? 1 : 0;
  };
  return {inside(second), inside(first), is_outside(first) + 2 * is_outside(second), fraction};
}

LevelLines::Outputs LevelLines::exact(const Inputs& inputs) {
  const auto [x_1, x_0, y_1, y_0, width, base] = inputs;
  const std::int64_t tiles_in_row = width / 4 + (width % 4 == 0 ? 0 : 1);
  const std::int64_t row_0 = base + y_0 / 4 * tiles_in_row;
  const std::int64_t row_1 = base + y_1 / 4 * tiles_in_row;
  return {row_1 + x_1 / 4, row_1 + x_0 / 4, row_0 + x_1 / 4, row_0 + x_0 / 4};
}

DecodeTexel::Outputs DecodeTexel::exact(const Inputs& inputs) {
  const auto [texel_format, srgb, column, word] = inputs;
  const std::array<std::int64_t, 4> byte{word % 256, word / 256 % 256, word / 65536 % 256, word / 16777216};
  const bool decodes = srgb != 0;
  const auto colour = [&](std::int64_t code) {
    return decodes ? linear_of_srgb_table()[static_cast<std::size_t>(code)] : 16 * code;
  };
  const auto at = static_cast<std::size_t>(column & 3);
  switch (static_cast<TexelFormat>(texel_format)) {
    case TexelFormat::kR8: return {16 * 255, 0, 0, colour(byte[at])};
    case TexelFormat::kRg8: return {16 * 255, 0, colour(byte[at % 2 * 2 + 1]), colour(byte[at % 2 * 2])};
    case TexelFormat::kRgba8: break;
  }
  return {16 * byte[3], colour(byte[2]), colour(byte[1]), colour(byte[0])};
}

KernelWeight::Outputs KernelWeight::exact(const Inputs& inputs) {
  return {gaussian_table()[static_cast<std::size_t>(inputs[0] & 255)]};
}

InterpolateTexels::Outputs InterpolateTexels::exact(const Inputs& inputs) {
  const auto [a, b, fraction] = inputs;
  return {(256 - fraction) * a + fraction * b};
}

// One sum of eight texels, each with the product of its three shares.
FilterTexels::Outputs FilterTexels::exact(const Inputs& inputs) {
  const bool gaussian = inputs[0] == 1 && inputs[1] == 1;
  const auto share = [&](std::size_t field) {
    return gaussian ? gaussian_table()[static_cast<std::size_t>(inputs[field] & 255)] : inputs[field];
  };
  std::int64_t colour = 0;
  for (std::size_t texel = 0; texel < 8; ++texel) {
    const bool coarse = texel >= 4;
    const std::int64_t x = share(coarse ? 5 : 3);
    const std::int64_t y = share(coarse ? 6 : 4);
    colour += inputs[7 + texel] * (coarse ? inputs[2] : 256 - inputs[2]) * (texel % 2 == 1 ? x : 256 - x) *
              (texel % 4 >= 2 ? y : 256 - y);
  }
  return {colour};
}

WeighColour::Outputs WeighColour::exact(const Inputs& inputs) {
  const auto [weight, colour] = inputs;
  // The product is U8.36; the whole halves of U8.8's last bit in it, then the nearest whole, ties up.
  const auto halves = static_cast<std::int64_t>(static_cast<double>(weight * colour) * 0x1p-27);
  return {(halves + 1) / 2};
}

template void evaluate_exact<ProbeWeight>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<ProbePosition>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<LevelSize>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<AxisTexels>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<LevelLines>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<DecodeTexel>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<KernelWeight>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<InterpolateTexels>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<FilterTexels>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<WeighColour>(const std::uint64_t*, std::uint64_t*, std::size_t);

}  // namespace feline::prove
