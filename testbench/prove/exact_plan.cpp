// SPDX-License-Identifier: Apache-2.0
// What the leaves of plan must give, stated once more from their contracts: quotients and roundings in doubles, which
// hold every number here exactly. A quotient's floor is exact, too: no integer lies within a double's error of it.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "testbench/prove/exact_rounding.h"
#include "testbench/prove/exact_tables.h"
#include "testbench/prove/lane_loop.h"
#include "testbench/prove/leaves.h"

namespace feline::prove {
namespace {

__extension__ using Wide = __int128;

constexpr bool is_mode(std::int64_t code, Mode mode) { return code == static_cast<std::int64_t>(mode); }

constexpr double real(std::int64_t x) { return static_cast<double>(x); }

// Which multiples of 1/256 the logarithms of 256/256 .. 512/256 are nearest to.
const std::array<std::int64_t, 257>& log2_table() {
  static const std::array<std::int64_t, 257> table = [] {
    std::array<std::int64_t, 257> log2{};
    const auto& table = oracle::tables().log2;
    std::copy(table.begin(), table.end(), log2.begin());
    log2[256] = 256;
    return log2;
  }();
  return table;
}

// 1/k in 1/65536; as many as a count of probes can say, 0 where there is none.
const std::array<std::int64_t, 64>& reciprocals_table() {
  static const std::array<std::int64_t, 64> table = [] {
    std::array<std::int64_t, 64> reciprocals{};
    const auto& table = oracle::tables().reciprocal;
    std::copy(table.begin(), table.end(), reciprocals.begin());
    return reciprocals;
  }();
  return table;
}

std::int64_t reciprocal_of(std::int64_t count) { return reciprocals_table()[static_cast<std::size_t>(count & 63)]; }

constexpr std::int64_t kMostWanted = 31;
constexpr std::int64_t kMostEighths = 127;

// How many multiples of `step`, from 1 * step on, are not above `end`; none is above without a step.
std::int64_t multiples_up_to(std::int64_t end, std::int64_t step, std::int64_t most) {
  return static_cast<std::int64_t>(std::min(real(most), real(end) / real(step)));
}

// And how many are below.
std::int64_t multiples_below(std::int64_t end, std::int64_t step, std::int64_t most) {
  const std::int64_t count = multiples_up_to(end, step, most + 1);
  return std::min(count - (count * step == end ? 1 : 0), most);
}

}  // namespace

ClampRadii::Outputs ClampRadii::exact(const Inputs& inputs) {
  const auto [mode, length_factor, exponent, major_radius, minor_radius] = inputs;
  // In the last bits of the radii; less than one of them reads as none, as minor_radius does.
  const double texel = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + 7 - exponent) << 52);
  if (real(major_radius) < texel) return {1, major_radius, major_radius};
  const std::int64_t minor = std::max(minor_radius, static_cast<std::int64_t>(texel));
  const std::int64_t shortened = nearest(real(major_radius * length_factor) * 0x1p-8);
  return {0, is_mode(mode, Mode::kExt) ? major_radius : std::max(shortened, minor), minor};
}

WantedProbes::Outputs WantedProbes::exact(const Inputs& inputs) {
  const auto [mode, probe_rounding, probe_factor, major, minor] = inputs;
  const std::int64_t eighths = multiples_up_to(8 * major, minor, kMostEighths);
  if (is_mode(mode, Mode::kExt)) {
    // One more than the probes that end before the major radius does.
    const std::int64_t wanted = 1 + multiples_below(major, minor, kMostWanted - 1);
    return {wanted, eighths};
  }
  if (probe_rounding != 0) return {multiples_below(2 * probe_factor * major, 256 * minor, kMostWanted), eighths};
  // fProbes = eighths/4 - 1; halves round up.
  return {(eighths - 2) / 4, eighths};
}

ChooseProbes::Outputs ChooseProbes::exact(const Inputs& inputs) {
  const auto [magnified, max_probes, wanted] = inputs;
  if (magnified != 0) return {1, 0};
  if (wanted > max_probes) return {max_probes, 1};
  return {wanted == 0 ? 1 : wanted, 0};
}

FitRadius::Outputs FitRadius::exact(const Inputs& inputs) {
  const auto [mode, probe_rounding, blur_factor, inverse_alias, limited, probes, major, minor] = inputs;
  if (is_mode(mode, Mode::kExt)) return {nearest(real(major * reciprocal_of(probes)) * 0x1p-16)};
  const std::int64_t widened = nearest(real(major * reciprocal_of(probes + 1)) * 0x1p-15);
  if (probe_rounding == 0) return {std::max(widened, minor)};
  if (limited != 0) return {nearest(real(widened * inverse_alias) * 0x1p-8)};
  return {std::min(widened, nearest(real(minor * blur_factor) * 0x1p-8))};
}

LevelOfRadius::Outputs LevelOfRadius::exact(const Inputs& inputs) {
  const auto [exponent, radius] = inputs;
  if (radius == 0) return {-32 * 256};
  int octave = 0;
  const double part = std::frexp(real(radius), &octave);
  const std::int64_t significand = nearest(part * 512);
  const std::int64_t level =
      (octave - 1 - 7 + exponent) * 256 + log2_table()[static_cast<std::size_t>(significand - 256)];
  return {std::min<std::int64_t>(std::max<std::int64_t>(level, -32 * 256), 32 * 256 - 1)};
}

SampledLevel::Outputs SampledLevel::exact(const Inputs& inputs) {
  const auto [mode, magnify, levels_cut, last_level, min_level, max_level, level_bias, base_level] = inputs;
  const std::int64_t lambda = std::min(std::max(base_level + level_bias, min_level), max_level);
  const bool one_level = is_mode(mode, Mode::kNearest) || is_mode(mode, Mode::kBilinear);
  // Of two levels as near, the finer: the coarser one begins past the middle.
  std::int64_t sampled = lambda;
  if (one_level) sampled = lambda % 256 > 128 ? lambda - lambda % 256 + 256 : lambda - lambda % 256;
  const std::int64_t last = 256 * last_level;
  const bool linear =
      lambda == 0 ? magnify == static_cast<std::int64_t>(Magnify::kLinear) : !is_mode(mode, Mode::kNearest);
  return {std::min(sampled, last), linear ? 1 : 0, levels_cut != 0 && sampled > last ? 1 : 0};
}

LineFraction::Outputs LineFraction::exact(const Inputs& inputs) {
  const auto [fitted, major, major_radius] = inputs;
  return {multiples_up_to(4096 * (major - fitted), major_radius, 8191)};
}

HalfStepFactor::Outputs HalfStepFactor::exact(const Inputs& inputs) {
  const auto [mode, probes, line] = inputs;
  if (probes <= 1) return {0};
  if (is_mode(mode, Mode::kExt)) return {nearest(real(reciprocal_of(probes + 1)) * 0.5)};
  return {nearest(real(line * reciprocal_of(probes - 1)) * 0x1p-12)};
}

// Bit by bit of the reciprocal.
TextureProduct::Outputs TextureProduct::exact(const Inputs& inputs) {
  const auto [reciprocal, vector] = inputs;
  std::int64_t product = 0;
  for (int bit = 0; bit < 16; ++bit) product += (reciprocal >> bit & 1) * (vector * (std::int64_t{1} << bit));
  return {product};
}

HalfStep::Outputs HalfStep::exact(const Inputs& inputs) {
  const auto [product, factor, size_shift, exponent] = inputs;
  const std::int64_t scaled = product * factor;
  const Wide twice = Wide{scaled < 0 ? -scaled : scaled} * 2;
  // In 2^-(8 + 15 + 16) textures at first.
  const auto drop = static_cast<int>(8 + 15 + 16 - 24 + size_shift - exponent);
  // |x| + 1/2 in halves.
  const Wide halves = drop < 0 ? (twice << -drop) + 1 : twice + (Wide{1} << drop);
  const Wide size = halves >> (1 + std::max(drop, 0));
  return {static_cast<std::int64_t>(scaled < 0 ? -size : size)};
}

WeightRow::Outputs WeightRow::exact(const Inputs& inputs) {
  const auto [mode, probes, eighths] = inputs;
  if (is_mode(mode, Mode::kExt)) return {61 + probes - 1};
  if (probes == 1) return {0};
  // Row 0 is one probe, fProbes 4/4.
  const std::int64_t quarters = eighths - 4;
  return {std::min(std::max(quarters, 4 * probes - 3), 4 * probes) - 4};
}

template void evaluate_exact<ClampRadii>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<WantedProbes>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<ChooseProbes>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<FitRadius>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<LevelOfRadius>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<SampledLevel>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<LineFraction>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<HalfStepFactor>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<TextureProduct>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<HalfStep>(const std::uint64_t*, std::uint64_t*, std::size_t);
template void evaluate_exact<WeightRow>(const std::uint64_t*, std::uint64_t*, std::size_t);

}  // namespace feline::prove
