// SPDX-License-Identifier: Apache-2.0
// fetch, filter and accumulate: what happens to texels.
#include <gtest/gtest.h>

#include "model/unit.h"
#include "tests/support/describe.h"
#include "tests/support/lookups.h"
#include "tests/support/oracle.h"
#include "tests/support/pruned_configs.h"
#include "tests/support/random_beat.h"
#include "tests/support/samplers.h"

namespace feline {
namespace {

// A walk beat anywhere near the texture, on any of its levels.
WalkBeat<kDefaultConfig> random_walk(Random& random, const State& state) {
  WalkBeat<kDefaultConfig> beat;
  beat.level_of_detail = beat.level_of_detail.from_raw(random.between(0, state.last_level.raw() << 8));
  beat.linear = beat.linear.from_raw(random.one_in(4) ? 0 : 1);
  beat.s = beat.s.from_raw(random.between(-3 << 24, 4 << 24));
  beat.t = beat.t.from_raw(random.between(-3 << 24, 4 << 24));
  draw_what_is_handed_on(random, beat);
  return beat;
}

State state_of(Random& random, const TestScene& scene) {
  return make_sampler<kDefaultConfig>(random_options(random), scene.texture, scene.memory);
}

// 1,000,000 probes into textures of every format and shape: lines of memory against the texture itself, and the tree
// of interpolations against one exact sum of eight products.
TEST(fetch, and_filter_equal_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_fetch.and_filter_equal_exact_arithmetic");
  const auto scenes = make_scenes(random, Content::kNoise);
  for (int i = 0; i < 1000000; ++i) {
    const TestScene& scene = scenes[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())))];
    const State state = state_of(random, scene);
    const auto addressed = oracle::address(random_walk(random, state), state);
    const auto fetched = fetch<kDefaultConfig>(addressed, state, scene.memory);
    const auto want = oracle::fetch(addressed, state, scene.texture);
    ASSERT_TRUE(same(fetched, want)) << mismatch(fetched, want, addressed, state);
    const auto filtered = filter<kDefaultConfig>(fetched, state);
    const auto exact = oracle::filter(fetched, state);
    ASSERT_TRUE(same(filtered, exact)) << mismatch(filtered, exact, fetched, state);
  }
}

// Of one texture of 4 x 4 texels and any border: what a configuration has no place for is 0, alpha one, and asked for
// only by an alpha in memory or border where all other channels have theirs.
template <Config kConfig>
void expect_constant_channels(const char* name) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for(name);
  const TestScene scene =
      make_scene(random, 4, 4, supported_format(kConfig.features, TexelFormat::kRgba8), false, Content::kNoise, 1);
  const int channels = bytes_per_texel(scene.texture.format);
  auto state = make_sampler<kConfig>(plain_options(supported_mode(kConfig.features, Mode::kTrilinear)),
                                     TextureShape{scene.texture.format, false, 4, 4, 1, scene.memory.level_base});
  std::array<int, 2> asked{};
  for (int i = 0; i < 1000; ++i) {
    for (auto& channel : state.border) channel = channel.from_raw(16 * (random.one_in(2) ? 255 : random.below(256)));
    AddressBeat<kConfig> beat;
    for (auto* each : {&beat.fine_x, &beat.fine_y, &beat.coarse_x, &beat.coarse_y}) {
      for (auto& index : *each) index = index.from_raw(random.below(4));
    }
    draw(random, beat.fine_border);
    draw(random, beat.coarse_border);
    draw(random, beat.coarse_used);
    const auto got = fetch<kConfig>(beat, state, scene.memory);
    bool asks = false;
    const auto expect_texel = [&](const auto& texel, const auto& xs, const auto& ys, std::int64_t border, int place) {
      const int column = place % 2;
      const int row = place / 2;
      const bool outside = (border >> column) % 2 != 0 || (border >> (2 + row)) % 2 != 0;
      const std::int64_t at = 4 * ys[static_cast<std::size_t>(row)].raw() + xs[static_cast<std::size_t>(column)].raw();
      for (int c = 0; c < 4; ++c) {
        const std::int64_t constant = c == 3 ? 255 * 16 : 0;
        const std::int64_t code =
            c < channels ? scene.texture.levels[0].texels[static_cast<std::size_t>(at * channels + c)] * 16 : constant;
        const std::int64_t there = outside ? state.border[static_cast<std::size_t>(c)].raw() : code;
        const bool has_place = has_channel(kConfig.features, c);
        ASSERT_EQ(texel[static_cast<std::size_t>(c)].raw(), has_place ? there : constant) << name << ", channel " << c;
        asks = asks || (c == 3 && channels == 4 && !has_place && there != constant);
      }
    };
    const std::array fine{got.fine_00, got.fine_10, got.fine_01, got.fine_11};
    const std::array coarse{got.coarse_00, got.coarse_10, got.coarse_01, got.coarse_11};
    for (int place = 0; place < 4; ++place) {
      expect_texel(fine[static_cast<std::size_t>(place)], beat.fine_x, beat.fine_y, beat.fine_border.raw(), place);
      if (beat.coarse_used.raw() == 0) continue;
      expect_texel(coarse[static_cast<std::size_t>(place)], beat.coarse_x, beat.coarse_y, beat.coarse_border.raw(),
                   place);
    }
    ASSERT_EQ(got.status.raw(), unsupported_if(asks)) << name;
    ++asked[asks ? 1 : 0];
  }
  EXPECT_EQ(asked[1] > 0, channels == 4 && !has_channel(kConfig.features, 3));
}

TEST(fetch, channels_left_out_are_constant) {
  expect_constant_channels<kDefaultConfig>("model_fetch.all_channels");
  expect_constant_channels<kSimpleUnit>("model_fetch.no_alpha");
  expect_constant_channels<kExtUnit>("model_fetch.two_channels");
  expect_constant_channels<kPlainUnit>("model_fetch.one_channel");
}

// Corners: every texel 0 or full, every fraction at its ends, both kernels.
TEST(filter, lattice_of_extremes) {
  for (int pattern = 0; pattern < 256; ++pattern) {
    for (int choice = 0; choice < 243; ++choice) {
      constexpr std::array<std::int64_t, 3> kFractions{0, 128, 255};
      FetchBeat<kDefaultConfig> beat;
      int rest = choice;
      for (auto* fraction :
           {&beat.fine_fraction_x, &beat.fine_fraction_y, &beat.coarse_fraction_x, &beat.coarse_fraction_y}) {
        *fraction = fraction->from_raw(kFractions[static_cast<std::size_t>(rest % 3)]);
        rest /= 3;
      }
      beat.level_fraction = beat.level_fraction.from_raw(kFractions[static_cast<std::size_t>(rest)]);
      int bit = 0;
      for (auto* texel : {&beat.fine_00, &beat.fine_10, &beat.fine_01, &beat.fine_11, &beat.coarse_00, &beat.coarse_10,
                          &beat.coarse_01, &beat.coarse_11}) {
        for (auto& channel : *texel) channel = channel.from_raw((pattern >> bit) % 2 != 0 ? 4095 : 0);
        ++bit;
      }
      beat.linear = beat.linear.from_raw(1);
      for (int kernel = 0; kernel < 2; ++kernel) {
        State state;
        state.kernel = state.kernel.from_raw(kernel);
        const auto got = filter<kDefaultConfig>(beat, state);
        const auto want = oracle::filter(beat, state);
        ASSERT_TRUE(same(got, want)) << mismatch(got, want, beat, state);
      }
    }
  }
}

// A colour below 2^28 whose product with an odd weight is `product`, modulo 2^28.
std::int64_t colour_of_product(std::int64_t weight, std::int64_t product) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << 28) - 1;
  // Newton's iteration: each step doubles the bits of 1 / weight that are right, of which weight itself has 3.
  const auto odd = static_cast<std::uint64_t>(weight);
  std::uint64_t inverse = odd;
  for (int bits = 3; bits < 28; bits *= 2) inverse *= 2 - odd * inverse;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(product) * inverse & kMask);
}

// Moves the sum of a channel to at most two of its 36th bits from a tie, by a probe of odd weight, if there is one.
void move_to_tie(Random& random, std::vector<FilterBeat<kDefaultConfig>>& beats, std::size_t channel) {
  const auto odd = std::ranges::find_if(beats, [](const auto& beat) { return beat.weight.raw() % 2 != 0; });
  if (odd == beats.end()) return;
  std::int64_t others = 0;
  for (const auto& beat : beats) others += beat.weight.raw() * beat.colour[channel].raw();
  others -= odd->weight.raw() * odd->colour[channel].raw();
  const std::int64_t wanted = (std::int64_t{1} << 27) + random.between(-2, 2);
  odd->colour[channel] = odd->colour[channel].from_raw(colour_of_product(odd->weight.raw(), wanted - others));
}

// 1,000,000 pixels of one to sixteen probes: the running sum against the exact rational sum, rounded once (GMP). A
// quarter of them ties, a quarter ties or next to one, where weights allow it.
TEST(accumulate, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_accumulate.equals_exact_arithmetic");
  Accumulator<kDefaultConfig> sum{};  // never cleared: `first` does it
  for (int i = 0; i < 1000000; ++i) {
    const int probes = static_cast<int>(random.between(1, 16));
    const auto& weights =
        oracle::tables().weight[static_cast<std::size_t>(random.one_in(2) ? 60 + probes : 4 * probes - 4)];
    std::vector<FilterBeat<kDefaultConfig>> beats(static_cast<std::size_t>(probes));
    const bool ties = random.one_in(4);
    for (int p = 0; p < probes; ++p) {
      auto& beat = beats[static_cast<std::size_t>(p)];
      draw(random, beat.tag);
      beat.first = beat.first.from_raw(p == 0);
      beat.last = beat.last.from_raw(p == probes - 1);
      beat.status = beat.status.from_raw(random.one_in(4) ? random.below(16) : 0);
      const int n = 2 * p - (probes - 1);
      beat.weight = beat.weight.from_raw(weights[static_cast<std::size_t>((std::abs(n) + 1) / 2)]);
      for (auto& channel : beat.colour) {
        const auto raw = static_cast<std::int64_t>(random.bits() >> 28) % (std::int64_t{255} << 28);
        channel = channel.from_raw(ties ? raw >> 19 << 19 : raw);
      }
    }
    if (!ties && random.one_in(3)) {
      for (std::size_t c = 0; c < 4; ++c) move_to_tie(random, beats, c);
    }
    std::optional<AccumulateBeat<kDefaultConfig>> got;
    for (const auto& beat : beats) {
      ASSERT_FALSE(got.has_value());
      got = accumulate<kDefaultConfig>(beat, sum);
    }
    ASSERT_TRUE(got.has_value());
    const auto want = oracle::accumulate(beats);
    ASSERT_TRUE(same(*got, want)) << mismatch(*got, want, beats.front(), beats.back());
    if (i % 100 != 0) continue;
    for (std::size_t c = 0; c < 4; ++c) {
      mpq_class exact = 0;
      for (const auto& beat : beats)
        exact += mpq_class(beat.weight.raw(), 256) * mpq_class(mpz_class(beat.colour[c].raw()), mpz_class(1) << 28);
      const mpq_class scaled = exact * 256 + mpq_class(1, 2);
      mpz_class whole;
      mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
      ASSERT_EQ(got->colour[c].raw(), whole.get_si());
    }
  }
}

// Weights that a configuration leaves out sum to nothing; the lookup is then unsupported.
TEST(accumulate, channels_left_out_are_constant) {
  FilterBeat<kSimpleUnit> beat;
  for (auto& channel : beat.colour)
    channel = channel.from_raw(std::int64_t{255} << Formats<kSimpleUnit>::kFiltered.fraction_bits);
  beat.first = beat.last = beat.last.from_raw(1);
  Accumulator<kSimpleUnit> sum;
  const auto got = accumulate<kSimpleUnit>(beat, sum);
  ASSERT_TRUE(got.has_value());
  EXPECT_EQ(got->colour[0].raw(), 0);
  EXPECT_EQ(got->colour[3].raw(), std::int64_t{255} << kSimpleUnit.pixel_fraction_bits);
}

// The whole unit, 300,000 lookups of every kind into every shape, format, mode and wrap, against the whole oracle.
TEST(unit, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_unit.equals_exact_arithmetic");
  const auto scenes = make_scenes(random, Content::kNoise);
  for (int i = 0; i < 300000; ++i) {
    const TestScene& scene = scenes[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())))];
    const State state = state_of(random, scene);
    const auto request = make_request<kDefaultConfig>(
        any_lookup(random, scene.texture.levels[0].width, scene.texture.levels[0].height), i);
    const auto got = sample<kDefaultConfig>(request, state, scene.memory);
    const auto want = oracle::sample(request, state, scene.texture);
    ASSERT_TRUE(same(got, want)) << mismatch(got, want, request, state);
  }
}

}  // namespace
}  // namespace feline
