// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/close_batches.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "model/unit.h"
#include "testbench/cosim/random_batches.h"
#include "testbench/parallel.h"

namespace feline {
namespace {

using F = Formats<kUnit>;
using Sums = std::array<std::int64_t, 4>;
constexpr int kDropped = F::kAccumulated.fraction_bits - F::kPixel.fraction_bits;
constexpr std::int64_t kOne = std::int64_t{1} << kDropped;
constexpr int kLevels = 3;
constexpr int kSize = 1 << (kLevels - 1);
constexpr std::size_t kFree = 4;  // texels that are chosen
constexpr std::size_t kCodes = 256;
constexpr std::size_t kAlpha = 3;

// What each probe adds to the sums.
std::vector<Sums> products_of(const Lookup& lookup, const SamplerState<kUnit>& sampler, const TextureMemory& memory) {
  std::vector<Sums> products;
  sample<kUnit>(make_request<kUnit>(lookup, 0), sampler, memory, [&]<typename Beat>(const Beat& beat) {
    if constexpr (std::is_same_v<Beat, FilterBeat<kUnit>>) {
      Sums& product = products.emplace_back();
      for (std::size_t c = 0; c < 4; ++c) product[c] = beat.colour[c].raw() * beat.weight.raw();
    }
  });
  return products;
}

Sums sum_of(const std::vector<Sums>& products) {
  Sums sums{};
  for (const Sums& product : products) {
    for (std::size_t c = 0; c < 4; ++c) sums[c] += product[c];
  }
  return sums;
}

// By how much a sum is past the last value at which the pixel's code goes up, in steps of the sum.
std::int64_t beyond(std::int64_t sum) { return (sum + kOne / 2) & (kOne - 1); }

// At an edge: with the border around the texture, whose alpha alone has fraction bits.
SamplerOptions blending_sampler(SplitMix64& random, bool at_edge) {
  SamplerChoices choices;
  const bool has_border = std::ranges::find(choices.wraps, Wrap::kClampToBorder) != choices.wraps.end();
  if (at_edge && has_border) choices.wraps = {Wrap::kClampToBorder};
  std::erase_if(choices.modes, [](Mode mode) { return mode == Mode::kNearest || mode == Mode::kBilinear; });
  SamplerOptions options = random_sampler(random, choices);
  const SamplerOptions plain;
  options.level_bias = plain.level_bias;
  options.min_level = plain.min_level;
  // A low last level, between two of the texture's: it is blended also where a derivative overflows.
  options.max_level = random.below(4) == 0 ? (kLevels - 1) * random.unit() : plain.max_level;
  // The fewer probes, the larger their products.
  if (random.below(2) == 0) options.max_probes = std::min(3, kUnit.max_probes);
  return options;
}

// Near the texture's edges.
float edge_coordinate(SplitMix64& random) {
  const auto edge = static_cast<float>(random.below(2));
  return edge + static_cast<float>(0.4 * random.unit() - 0.2);
}

// One that raises a status bit, and leaves the footprint, and so the probes, as they are.
float status_coordinate(SplitMix64& random) {
  using Limits = std::numeric_limits<float>;
  constexpr std::array kCoordinates{-Limits::max(), Limits::max(), Limits::infinity(), Limits::quiet_NaN()};
  return kCoordinates[random.below(kCoordinates.size())];
}

// A texture with one lookup, and what each code of a texel gives to its sums.
class Steered {
 public:
  Steered(SplitMix64& random, bool at_edge, bool raises_status)
      : texture_(random_texture(random, TexelFormat::kRgba8, random.below(2) != 0, kSize, kSize, kLevels)),
        options_(blending_sampler(random, at_edge)),
        lookup_(random_lookup(random, kSize, kSize)) {
    at_edge_ = at_edge && options_.wrap_s == Wrap::kClampToBorder;
    if (at_edge) lookup_.s = edge_coordinate(random), lookup_.t = edge_coordinate(random);
    if (raises_status) (random.below(2) == 0 ? lookup_.s : lookup_.t) = status_coordinate(random);
  }

  // Chooses four texels so that each channel's sum is next to where its code goes up. False when the lookup touches
  // fewer, or, at an edge, when alpha's sum cannot come there, or not from fractions of codes.
  bool steer(SplitMix64& random) {
    Sums wanted{};
    // A tie, or the step before it, which is 16 of a linear channel; or a few around.
    constexpr std::array<std::int64_t, 3> kSteps{0, -1, -16};
    for (std::int64_t& steps : wanted) {
      const std::uint32_t kind = random.below(4);
      steps = kind < 3 ? kSteps[kind] : static_cast<std::int64_t>(random.below(256)) - 128;
    }
    if (at_edge_ && !borders_reach(wanted[kAlpha])) return false;
    const std::vector<std::uint8_t*> free = finest();
    if (free.size() < kFree) return false;
    for (std::uint8_t* const texel : free) std::fill_n(texel, 4, std::uint8_t{0});
    const Sums rest = sums();
    std::array<std::array<Sums, kCodes>, kFree> gives{};
    for (std::size_t i = 0; i < kFree; ++i) {
      for (std::size_t code = 0; code < kCodes; ++code) {
        std::fill_n(free[i], 4, static_cast<std::uint8_t>(code));
        gives[i][code] = sums();
        for (std::size_t c = 0; c < 4; ++c) gives[i][code][c] -= rest[c];
      }
      std::fill_n(free[i], 4, std::uint8_t{0});
    }
    for (std::size_t c = 0; c < 4; ++c) {
      // What is wanted below comes from below, where the texels' steps do not reach it.
      const std::int64_t sign = wanted[c] < 0 ? -1 : 1;
      const auto give = [&](std::size_t i, std::size_t code) { return sign * gives[i][code][c]; };
      const std::array<std::size_t, kFree> codes =
          meet(give, sign * (wanted[c] - beyond(rest[c])), random.below(kCodes * kCodes));
      for (std::size_t i = 0; i < kFree; ++i) free[i][c] = static_cast<std::uint8_t>(codes[i]);
    }
    return true;
  }

  TextureMemory memory() const { return layout_texture(texture_); }
  SamplerState<kUnit> sampler() const { return make_sampler<kUnit>(options_, texture_, memory()); }
  const Lookup& lookup() const { return lookup_; }

 private:
  std::vector<Sums> products() const {
    const TextureMemory laid_out = memory();
    return products_of(lookup_, make_sampler<kUnit>(options_, texture_, laid_out), laid_out);
  }
  Sums sums() const { return sum_of(products()); }

  // Whether alpha, of which texels give whole codes, gets fractions of them from borders, which leave it where it can
  // come to the wanted steps.
  bool borders_reach(std::int64_t wanted) const {
    constexpr std::int64_t kCode = 1 << F::kChannel.fraction_bits;
    const std::vector<Sums> all = products();
    return (sum_of(all)[kAlpha] - wanted) % kCode == 0 &&
           std::ranges::any_of(all, [](const Sums& product) { return product[kAlpha] % kCode != 0; });
  }

  // The texels whose least step is least.
  std::vector<std::uint8_t*> finest() {
    const Sums before = sums();
    std::vector<std::pair<int, std::uint8_t*>> steps;
    for (MipLevel& level : texture_.levels) {
      for (std::size_t at = 0; at < level.texels.size(); at += 4) {
        // Alpha, which sRGB leaves as it is.
        std::uint8_t& alpha = level.texels[at + kAlpha];
        alpha ^= 1;
        const std::int64_t step = sums()[kAlpha] - before[kAlpha];
        alpha ^= 1;
        if (step != 0) steps.emplace_back(std::countr_zero(static_cast<std::uint64_t>(step)), &level.texels[at]);
      }
    }
    // Stable: texels of one step stay in the texture's order, not that of their addresses.
    std::ranges::stable_sort(steps, {}, &std::pair<int, std::uint8_t*>::first);
    std::vector<std::uint8_t*> texels;
    // At an edge alpha is to come to the wanted step itself, not near it.
    if (at_edge_ && (steps.empty() || steps.front().first > F::kChannel.fraction_bits)) return texels;
    for (std::size_t i = 0; i < std::min(kFree, steps.size()); ++i) texels.push_back(steps[i].second);
    return texels;
  }

  // Codes of the four texels that give `wanted` together, modulo kOne, or a little more. The pairs of codes of the last
  // two are tried from `start` on.
  template <typename Give>
  static std::array<std::size_t, kFree> meet(const Give& give, std::int64_t wanted, std::size_t start) {
    constexpr std::size_t kPairs = kCodes * kCodes;
    std::vector<std::pair<std::int64_t, std::size_t>> pairs;
    for (std::size_t both = 0; both < kPairs; ++both) {
      pairs.emplace_back((give(0, both / kCodes) + give(1, both % kCodes)) & (kOne - 1), both);
    }
    std::ranges::sort(pairs);
    std::int64_t nearest = kOne;
    std::array<std::size_t, kFree> codes{};
    for (std::size_t i = 0; i < kPairs && nearest != 0; ++i) {
      const std::size_t others = (start + i) % kPairs;
      const std::int64_t missing = (wanted - give(2, others / kCodes) - give(3, others % kCodes)) & (kOne - 1);
      const auto found = std::ranges::lower_bound(pairs, std::pair(missing, std::size_t{0}));
      if (found == pairs.end() || found->first - missing >= nearest) continue;
      nearest = found->first - missing;
      codes = {found->second / kCodes, found->second % kCodes, others / kCodes, others % kCodes};
    }
    return codes;
  }

  Texture texture_;
  SamplerOptions options_;
  Lookup lookup_;
  bool at_edge_ = false;
};

}  // namespace

CloseBatches::Close CloseBatches::choose(std::uint64_t seed, std::uint64_t number) {
  SplitMix64 random(derived_seed(seed, number));
  for (;;) {
    Steered steered(random, number % 2 != 0, number / 4 % 4 == 0);
    if (steered.steer(random)) {
      Close close{steered.sampler(), steered.memory(), {}};
      close.lookups.fill(steered.lookup());
      return close;
    }
  }
}

CloseBatches::CloseBatches(std::uint64_t seed, std::uint64_t lookups) : batches_(lookups) {
  for_each_index(0, static_cast<std::int64_t>(lookups), [&](std::int64_t i) {
    batches_[static_cast<std::size_t>(i)] = choose(seed, static_cast<std::uint64_t>(i));
  });
}

Batch CloseBatches::operator[](std::size_t i) const {
  const Close& close = batches_[i];
  // Half of them wait for each other behind a pixel that is not taken, for as many cycles as may be.
  std::optional<Conditions> conditions;
  if (i / 2 % 2 != 0) {
    conditions.emplace().memory_latency = 1;
    conditions->at(Port::kPixel) = {0.2, 40};
  }
  return {close.sampler, &close.memory, close.lookups, i * close.lookups.size(), false, conditions};
}

std::int64_t CloseBatches::distance(std::size_t i, std::size_t channel) const {
  const Close& close = batches_[i];
  const std::int64_t steps = beyond(sum_of(products_of(close.lookups.front(), close.sampler, close.memory))[channel]);
  return steps < kOne / 2 ? steps : steps - kOne;
}

}  // namespace feline
