// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/vast_batches.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

#include "testbench/mip_chain.h"

namespace feline::coverage {
namespace {

constexpr int kLargest = 1 << kUnit.max_size_log2;

std::int64_t lines_of_the_largest() {
  std::int64_t lines = 0;
  for (int level = 0; level < mip_count(kLargest, kLargest); ++level) {
    lines += level_lines(mip_size(kLargest, level), mip_size(kLargest, level));
  }
  return lines;
}

// As likely in any octave, and the largest now and then.
int any_side(SplitMix64& random) {
  if (random.below(6) == 0) return kLargest;
  const std::uint32_t octave = random.below(kUnit.max_size_log2);
  return (1 << octave) + static_cast<int>(random.below(1u << octave));
}

// The reciprocal of a power of two and one has all bits that it can.
int thin_side(SplitMix64& random) { return random.below(2) == 0 ? 1 : 1 + (1 << random.below(kUnit.max_size_log2)); }

double signed_unit(SplitMix64& random) { return 2 * random.unit() - 1; }

Lookup around_the_edges(SplitMix64& random, const TextureShape& shape) {
  const double size = std::ldexp(1, static_cast<int>(random.below(6)));
  const auto step = [&](int side) { return static_cast<float>(signed_unit(random) * size / side); };
  const auto position = [&] { return static_cast<float>(0.5 + 0.8 * signed_unit(random)); };
  return {position(), position(), step(shape.width), step(shape.height), step(shape.width), step(shape.height)};
}

// A long and a short gradient, often along an axis or a diagonal, of any length that may take several probes. Now and
// then the longest that does: past it the level would be beyond the last.
Lookup long_line(SplitMix64& random, const TextureShape& shape, int max_probes) {
  constexpr int kLongestLog2 = kUnit.max_size_log2 + 5;
  const double angle =
      random.below(4) != 0 ? std::numbers::pi / 4 * random.below(8) : 2 * std::numbers::pi * random.unit();
  const auto octave = static_cast<int>(random.below(kLongestLog2));
  const double length = random.below(4) == 0 ? kLargest * (max_probes + 1) * (1 + 0.03 * signed_unit(random))
                                             : std::ldexp(1 + random.unit(), octave);
  const auto ratio_octave = static_cast<int>(random.below(6));
  const double ratio = std::ldexp(random.unit(), -ratio_octave);
  const double turn = random.below(2) == 0 ? std::numbers::pi / 2 : 2 * std::numbers::pi * random.unit();
  const auto part = [&](double of, double side) { return static_cast<float>(of / side); };
  return {static_cast<float>(signed_unit(random)),
          static_cast<float>(signed_unit(random)),
          part(length * std::cos(angle), shape.width),
          part(length * std::sin(angle), shape.height),
          part(ratio * length * std::cos(angle + turn), shape.width),
          part(ratio * length * std::sin(angle + turn), shape.height)};
}

}  // namespace

VastBatches::VastBatches(std::uint64_t seed) : random_(seed) {
  memory_.bytes.resize(static_cast<std::size_t>(lines_of_the_largest()) * kLineBytes);
  for (std::size_t at = 0; at < memory_.bytes.size(); at += sizeof(std::uint64_t)) {
    const std::uint64_t word = random_.next();
    std::memcpy(memory_.bytes.data() + at, &word, sizeof word);
  }
}

Batch VastBatches::make(Choice choice, std::size_t lookups) {
  SamplerOptions options = random_sampler(random_, {});
  TextureShape shape{
      static_cast<TexelFormat>(random_.below(3)), random_.below(2) != 0, any_side(random_), any_side(random_), 1, {}};
  if (choice == Choice::kBorder) {
    options.wrap_s = options.wrap_t = Wrap::kClampToBorder;
    options.level_bias = 0;
    shape.format = TexelFormat::kRgba8;
    shape.width = 1 + static_cast<int>(random_.below(40));
    shape.height = 1 + static_cast<int>(random_.below(40));
  }
  if (choice == Choice::kThin) {
    options.mode = static_cast<Mode>(static_cast<std::uint32_t>(Mode::kExt) + random_.below(3));
    options.max_probes = random_.below(2) == 0 ? 2 : 1 + static_cast<int>(random_.below(kUnit.max_probes));
    if (random_.below(2) == 0) options.probes = {ProbeRounding::kCeiling, 1, 1, 2};
    shape.width = thin_side(random_);
    shape.height = random_.below(4) == 0 ? thin_side(random_) : kLargest;
    if (random_.below(2) == 0) std::swap(shape.width, shape.height);
  }
  const int most = mip_count(shape.width, shape.height);
  shape.levels = random_.below(3) == 0 ? 1 + static_cast<int>(random_.below(static_cast<std::uint32_t>(most))) : most;
  // Those past the last level are never read.
  for (int level = 0; level < Formats<kUnit>::kLevels; ++level) {
    const auto spare = static_cast<std::int64_t>(memory_.lines()) -
                       level_lines(mip_size(shape.width, level), mip_size(shape.height, level));
    shape.level_base.push_back(random_.below(static_cast<std::uint32_t>(spare + 1)));
  }
  lookups_.clear();
  for (std::size_t i = 0; i < lookups; ++i) {
    lookups_.push_back(choice == Choice::kBorder ? around_the_edges(random_, shape)
                       : choice == Choice::kThin ? long_line(random_, shape, options.max_probes)
                                                 : random_lookup(random_, shape.width, shape.height));
    // Just below a half: rounding carries into a bit that no other value does.
    constexpr std::uint32_t kBelowHalf = 0x3effffff;
    if (random_.below(64) == 0) lookups_.back().s = lookups_.back().t = std::bit_cast<float>(kBelowHalf);
  }
  Batch batch{make_sampler<kUnit>(options, shape), &memory_, lookups_, 0};
  batch.sampler.levels_cut = batch.sampler.levels_cut.from_raw(random_.below(4) == 0 ? 1 : 0);
  batch.sampler.probes_cut = batch.sampler.probes_cut.from_raw(random_.below(4) == 0 ? 1 : 0);
  return batch;
}

}  // namespace feline::coverage
