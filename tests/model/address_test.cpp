// SPDX-License-Identifier: Apache-2.0
#include "model/address.h"

#include <gtest/gtest.h>

#include "tests/support/describe.h"
#include "tests/support/oracle.h"
#include "tests/support/random_beat.h"
#include "tests/support/samplers.h"

namespace feline {
namespace {

State state_of(int width, int height, Wrap wrap_s, Wrap wrap_t) {
  SamplerOptions options;
  options.wrap_s = wrap_s;
  options.wrap_t = wrap_t;
  int levels = 1;
  while ((std::max(width, height) >> levels) > 0) ++levels;
  std::vector<std::int64_t> bases;
  for (int k = 0; k < levels; ++k) bases.push_back(std::int64_t{k} * 1000000);
  return oracle::sampler_state(options, TexelFormat::kR8, false, width, height, levels, bases);
}

void expect_as_oracle(const WalkBeat<kDefaultConfig>& walked, const State& state) {
  const auto got = address<kDefaultConfig>(walked, state);
  const auto want = oracle::address(walked, state);
  ASSERT_TRUE(same(got, want)) << mismatch(got, want, walked, state);
}

std::int64_t random_position(Random& random, std::int64_t size) {
  switch (random.below(4)) {
    case 0: return static_cast<std::int64_t>(random.bits() >> 20) - (std::int64_t{1} << 43);
    case 1: return random.between(-3 << 24, 4 << 24);
    // Within two units of an edge or centre of a texel.
    case 2: return (random.between(-4 * size, 6 * size) << 24) / (2 * size) + random.between(-2, 2);
    default: return (random.between(-3, 4) << 24) + random.between(-(1 << 12), 1 << 12);
  }
}

// 1,000,000 positions: anywhere, near the texture, at texel edges and centres, at whole textures; any size.
TEST(address, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_address.equals_exact_arithmetic");
  for (int i = 0; i < 1000000 && !HasFatalFailure(); ++i) {
    const int width = static_cast<int>(random.between(1, 1 << random.between(0, 14)));
    const int height = static_cast<int>(random.between(1, 1 << random.between(0, 14)));
    const State state = state_of(width, height, static_cast<Wrap>(random.below(4)), static_cast<Wrap>(random.below(4)));
    WalkBeat<kDefaultConfig> walked;
    walked.level_of_detail =
        walked.level_of_detail.from_raw(random.one_in(4) ? random.between(0, state.last_level.raw()) << 8
                                                         : random.between(0, state.last_level.raw() << 8));
    walked.s = walked.s.from_raw(random_position(random, std::max<std::int64_t>(width >> 1, 1)));
    walked.t = walked.t.from_raw(random_position(random, height));
    walked.linear = walked.linear.from_raw(random.below(2));
    draw_what_is_handed_on(random, walked);
    expect_as_oracle(walked, state);
  }
}

// Each of the sizes 1 .. 9 and 16384 at every quarter texel and a unit to either side, from -2 to 3 textures (to the
// first 16 texels and the last 16 of each texture when it is wide), in all wrap modes, linear and nearest.
TEST(address, lattice_of_positions) {
  for (const int size : {1, 2, 3, 4, 5, 6, 7, 8, 9, 16384}) {
    for (int wrap = 0; wrap < 4; ++wrap) {
      const State state = state_of(size, 1, static_cast<Wrap>(wrap), Wrap::kRepeat);
      for (std::int64_t turn = -2; turn <= 2; ++turn) {
        for (std::int64_t quarter = 0; quarter < 4 * size; ++quarter) {
          if (size > 100 && quarter > 64 && quarter < 4 * size - 64) continue;
          for (std::int64_t off = -1; off <= 1; ++off) {
            for (int linear = 0; linear < 2; ++linear) {
              WalkBeat<kDefaultConfig> walked;
              walked.linear = walked.linear.from_raw(linear);
              walked.s = walked.s.from_raw((turn << 24) + (quarter << 24) / (4 * size) + off);
              expect_as_oracle(walked, state);
              if (HasFatalFailure()) return;
            }
          }
        }
      }
    }
  }
}

// In words: what each wrap mode makes of a texture of 4 texels.
TEST(address, wrap_modes_by_example) {
  const auto columns = [](double s, Wrap wrap, bool linear) {
    WalkBeat<kDefaultConfig> walked;
    walked.linear = walked.linear.from_raw(linear);
    walked.s = walked.s.from_raw(static_cast<std::int64_t>(s * 0x1p24));
    const auto beat = address<kDefaultConfig>(walked, state_of(4, 4, wrap, Wrap::kRepeat));
    return std::array<std::int64_t, 4>{beat.fine_x[0].raw(), beat.fine_x[1].raw(), beat.fine_fraction_x.raw(),
                                       beat.fine_border.raw() & 3};
  };
  using Columns = std::array<std::int64_t, 4>;
  EXPECT_EQ(columns(0.0, Wrap::kRepeat, true), (Columns{3, 0, 128, 0}));
  EXPECT_EQ(columns(0.125, Wrap::kRepeat, true), (Columns{0, 1, 0, 0}));
  EXPECT_EQ(columns(1.0, Wrap::kRepeat, true), (Columns{3, 0, 128, 0}));
  EXPECT_EQ(columns(-0.25, Wrap::kRepeat, false), (Columns{3, 0, 0, 0}));
  EXPECT_EQ(columns(0.0, Wrap::kMirroredRepeat, true), (Columns{0, 0, 128, 0}));
  EXPECT_EQ(columns(1.0, Wrap::kMirroredRepeat, true), (Columns{3, 3, 128, 0}));
  EXPECT_EQ(columns(1.375, Wrap::kMirroredRepeat, true), (Columns{2, 3, 0, 0}));
  EXPECT_EQ(columns(-0.3, Wrap::kMirroredRepeat, false)[0], 1);
  EXPECT_EQ(columns(-5, Wrap::kClampToEdge, true), (Columns{0, 0, 128, 0}));
  EXPECT_EQ(columns(9, Wrap::kClampToEdge, false), (Columns{3, 3, 0, 0}));
  EXPECT_EQ(columns(0.0, Wrap::kClampToBorder, true), (Columns{0, 0, 128, 1}));
  EXPECT_EQ(columns(-3, Wrap::kClampToBorder, true)[3], 3);
  EXPECT_EQ(columns(1.0, Wrap::kClampToBorder, true), (Columns{3, 3, 128, 2}));
  EXPECT_EQ(columns(9, Wrap::kClampToBorder, false)[3], 3);
}

}  // namespace
}  // namespace feline
