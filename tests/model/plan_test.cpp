// SPDX-License-Identifier: Apache-2.0
#include "model/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "model/footprint.h"
#include "model/make_sampler.h"
#include "tests/support/describe.h"
#include "tests/support/footprints.h"
#include "tests/support/oracle.h"
#include "tests/support/pruned_configs.h"
#include "tests/support/random_beat.h"

namespace feline {
namespace {

State random_state(Random& random) {
  const int width = static_cast<int>(random.between(1, 1 << random.between(0, 14)));
  const int height = static_cast<int>(random.between(1, 1 << random.between(0, 14)));
  int levels = 1;
  while ((std::max(width, height) >> levels) > 0) ++levels;
  if (random.one_in(3)) levels = static_cast<int>(random.between(1, levels));
  return oracle::sampler_state(random_options(random), TexelFormat::kRgba8, false, width, height, levels, {});
}

void expect_as_oracle(const FootprintBeat<kDefaultConfig>& shaped, const State& state) {
  const auto got = plan<kDefaultConfig>(shaped, state);
  const auto want = oracle::plan(shaped, state);
  ASSERT_TRUE(same(got, want)) << mismatch(got, want, shaped, state);
}

// 1,000,000 footprints of random quadruples in every mode, parameter set, limit, bias and size; exponents mostly where
// radii are 1/4 to 2^16 texels.
TEST(plan, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_plan.equals_exact_arithmetic");
  for (int i = 0; i < 1000000 && !HasFatalFailure(); ++i) {
    const State state = random_state(random);
    const int exponent = static_cast<int>(random.one_in(8)   ? random.between(-64, 63)
                                          : random.one_in(8) ? random.between(10, 22)
                                                             : random.between(-9, 10));
    auto grouped = group_beat(random_quad(random), exponent);
    draw(random, grouped.s);
    draw(random, grouped.t);
    draw_what_is_handed_on(random, grouped);
    expect_as_oracle(footprint<kDefaultConfig>(grouped, state), state);
  }
}

// The largest footprints that still take more than one probe: a tiny lengthFactor shortens a line of 2^20 texels and
// more on a texture one texel wide, and a half step has more bits before the point than after it.
TEST(plan, shortened_lines_on_a_narrow_texture) {
  int several = 0;
  for (int length = 1; length <= 40; ++length) {
    SamplerOptions options = plain_options(Mode::kSimple);
    options.probes.length_factor = length / 256.0;
    for (const int limit : {2, 7, 16}) {
      options.max_probes = limit;
      for (const auto& [width, height] : {std::array{1, 16384}, {16384, 1}, {2, 16384}, {3, 9000}}) {
        const State state = oracle::sampler_state(options, TexelFormat::kR8, false, width, height, 14, {});
        for (int exponent = 8; exponent <= 24; ++exponent) {
          for (const Quad& quad :
               {Quad{127, -64, 0, 0}, Quad{-64, 127, 0, 0}, Quad{127, 127, 1, 1}, Quad{64, 0, 0, 0}}) {
            const auto shaped = footprint<kDefaultConfig>(group_beat(quad, exponent), state);
            expect_as_oracle(shaped, state);
            if (HasFatalFailure()) return;
            if (exponent > 15 && plan<kDefaultConfig>(shaped, state).probes.raw() > 1) ++several;
          }
        }
      }
    }
  }
  EXPECT_GT(several, 100);
}

// The major radius of a footprint is 0 or at least 64 * 128, its largest mantissa being at least 64.
//
// Radii at the corners of every comparison: minor 0, minor = major, and ratios k/2 and k/8 with a unit to either side,
// at every exponent, in the modes and parameter sets.
TEST(plan, lattice_of_ratios) {
  constexpr std::array<std::int64_t, 6> kMajors{0, 8192, 8193, 12000, 16383, 32767};
  for (const Mode mode : {Mode::kTrilinear, Mode::kExt, Mode::kSimple}) {
    for (const ProbeParameters& probes : {kExact, kHighQuality, kHighEfficiency}) {
      for (const int limit : {1, 2, 15, 16}) {
        SamplerOptions options = plain_options(mode);
        options.probes = probes;
        options.max_probes = limit;
        const State state = oracle::sampler_state(options, TexelFormat::kR8, false, 16384, 1000, 15, {});
        for (const std::int64_t major : kMajors) {
          for (std::int64_t eighths = 8; eighths <= 144; ++eighths) {
            for (std::int64_t off = -1; off <= 1; ++off) {
              const std::int64_t minor = std::clamp<std::int64_t>(8 * major / eighths + off, 0, major);
              FootprintBeat<kDefaultConfig> shaped;
              shaped.major_u = shaped.major_u.from_raw(major);
              shaped.major_v = shaped.major_v.from_raw(-major);
              shaped.major_radius = shaped.major_radius.from_raw(major);
              shaped.minor_radius = shaped.minor_radius.from_raw(minor);
              const std::int64_t first = eighths == 8 ? -64 : -9;
              for (std::int64_t exponent = first; exponent <= (eighths == 8 ? 63 : 9); exponent += 3) {
                shaped.exponent = shaped.exponent.from_raw(exponent);
                expect_as_oracle(shaped, state);
                if (HasFatalFailure()) return;
              }
            }
          }
        }
      }
    }
  }
}

// A texel is 128 at exponent 0, the last bit of a radius at exponent 7, and less than that from 8 on.
TEST(plan, radii_are_clamped_to_a_texel) {
  const auto clamped = [](std::int64_t major, std::int64_t minor, int exponent) {
    FootprintBeat<kDefaultConfig> shaped;
    shaped.major_radius = shaped.major_radius.from_raw(major);
    shaped.minor_radius = shaped.minor_radius.from_raw(minor);
    shaped.exponent = shaped.exponent.from_raw(exponent);
    const ClampedRadii radii = clamp_radii<kDefaultConfig>(shaped, Mode::kTable, 256);
    return std::array<std::int64_t, 3>{radii.magnified ? 1 : 0, radii.major, radii.minor};
  };
  using Radii = std::array<std::int64_t, 3>;
  EXPECT_EQ(clamped(127, 5, 0), (Radii{1, 127, 127}));
  EXPECT_EQ(clamped(128, 5, 0), (Radii{0, 128, 128}));
  EXPECT_EQ(clamped(129, 5, 0), (Radii{0, 129, 128}));
  EXPECT_EQ(clamped(8192, 0, 6), (Radii{0, 8192, 2}));
  EXPECT_EQ(clamped(8192, 0, 7), (Radii{0, 8192, 1}));
  EXPECT_EQ(clamped(8192, 0, 8), (Radii{0, 8192, 0}));
  EXPECT_EQ(clamped(0, 0, 8), (Radii{1, 0, 0}));
}

// What a unit without blending has of a level between two is the finer one, and said to be another.
TEST(plan, levels_without_blending_are_whole) {
  const auto state = make_sampler<kExtUnit>(plain_options(Mode::kTrilinear),
                                            TextureShape{TexelFormat::kR8, false, 2048, 2048, 12, {}});
  for (std::int64_t base = 0; base <= 11 << 8; ++base) {
    const LevelChoice choice = choose_level<kExtUnit>(base, Mode::kTrilinear, state);
    ASSERT_EQ(choice.level_of_detail, base >> 8 << 8);
    ASSERT_EQ(choice.missing, base % 256 != 0);
  }
}

// What walk reads of the weight table: all of a row, and no other rows (testbench/mutation/rules/feline_rules_walk.sv).
TEST(plan, a_row_of_weights_has_its_probe_count) {
  constexpr std::int64_t kGaussianRows = Formats<kDefaultConfig>::kGaussianRows;
  for (std::int64_t probes = 1; probes <= kDefaultConfig.max_probes; ++probes) {
    EXPECT_EQ((choose_weight_row<kDefaultConfig>({false, 64, 64}, Mode::kExt, probes)), kGaussianRows + probes - 1);
    std::set<std::int64_t> rows;
    for (std::int64_t major = 0; major <= 2048; ++major) {
      for (const std::int64_t minor : {0, 8}) {
        rows.insert(choose_weight_row<kDefaultConfig>({false, std::max(major, minor), minor}, Mode::kTable, probes));
      }
    }
    const std::int64_t first = *rows.begin();
    EXPECT_EQ(rows.size(), probes == 1 ? 1U : 4U);
    EXPECT_EQ(first, std::max<std::int64_t>(4 * probes - 7, 0));
    EXPECT_EQ(*rows.rbegin(), 4 * probes - 4);
  }
}

// Every radius, at an exponent without clamps: log2 of it, correctly rounded after rounding to 9 significant bits, so
// within 1/512 octave for the table and log2(1 + 2^-9) < 1/354 for the radius.
TEST(plan, level_of_every_radius) {
  for (std::int64_t radius = 1; radius <= 32767; ++radius) {
    const double got = level_of_radius<kDefaultConfig>(radius, 3).value();
    const double want = std::log2(static_cast<double>(radius) / 128 * 8);
    ASSERT_NEAR(got, want, 1.0 / 512 + 1.0 / 354) << radius;
    ASSERT_GE(got, (level_of_radius<kDefaultConfig>(radius - 1, 3).value())) << radius;
  }
  EXPECT_EQ(level_of_radius<kDefaultConfig>(0, 0).raw(), -32 * 256);
  EXPECT_EQ(level_of_radius<kDefaultConfig>(32767, 63).raw(), 32 * 256 - 1);
  EXPECT_EQ(level_of_radius<kDefaultConfig>(1, -64).raw(), -32 * 256);
}

// Bar 4: Simple takes 4 probes and Table as many as its radii say, near the ideal 9.
TEST(plan, the_papers_example) {
  const auto probes = [](Mode mode) {
    SamplerOptions options = plain_options(mode);
    const State state = oracle::sampler_state(options, TexelFormat::kR8, false, 256, 256, 9, {});
    return plan<kDefaultConfig>(footprint<kDefaultConfig>(group_beat({104, 0, 96, 40}, -3), state), state);
  };
  EXPECT_EQ(probes(Mode::kSimple).probes.raw(), 4);
  EXPECT_EQ(probes(Mode::kExt).probes.raw(), 2);
  const auto table = probes(Mode::kTable);
  EXPECT_NEAR(static_cast<double>(table.probes.raw()), 9, 1);
  EXPECT_NEAR(table.level_of_detail.value(), std::log2(3.606), 0.12);
  // Section 3.2 of the report computes 4.97 probes for the filter of figure 4; here 2 * 13/5.099 - 1 = 4.099.
  EXPECT_NEAR(probes(Mode::kSimple).level_of_detail.value(), std::log2(2 * 13.0 / 5), 0.03);
}

// Erratum 6: the two roundings are two modes. Errata 7: the radius after each.
TEST(plan, both_roundings_of_the_probe_count) {
  const auto plan_of = [](std::int64_t major, std::int64_t minor, const ProbeParameters& probes, int limit) {
    SamplerOptions options = plain_options(Mode::kSimple);
    options.probes = probes;
    options.max_probes = limit;
    const State state = oracle::sampler_state(options, TexelFormat::kR8, false, 4096, 4096, 13, {});
    FootprintBeat<kDefaultConfig> shaped;
    shaped.major_radius = shaped.major_radius.from_raw(major);
    shaped.minor_radius = shaped.minor_radius.from_raw(minor);
    return plan<kDefaultConfig>(shaped, state);
  };
  ProbeParameters ceiling = kExact;
  ceiling.rounding = ProbeRounding::kCeiling;
  EXPECT_EQ(plan_of(10240, 4096, kExact, 16).probes.raw(), 4);  // fProbes 4
  EXPECT_EQ(plan_of(10240, 4096, ceiling, 16).probes.raw(), 4);
  EXPECT_EQ(plan_of(10241, 4096, kExact, 16).probes.raw(), 4);  // just above: nearest stays, ceiling goes up
  EXPECT_EQ(plan_of(10241, 4096, ceiling, 16).probes.raw(), 5);
  EXPECT_EQ(plan_of(11264, 4096, kExact, 16).probes.raw(), 5);  // 4.5 goes up
  // Unlimited: as wide as blurFactor allows. Limited: 2 major/((iProbes + 1) aliasFactor).
  EXPECT_NEAR(plan_of(16384, 2048, kHighQuality, 16).level_of_detail.value(), std::log2(16 * 1.15625), 0.02);
  EXPECT_NEAR(plan_of(16384, 512, kHighQuality, 7).level_of_detail.value(), std::log2(2 * 128 * 0.9625 / 8 / 1.1532),
              0.02);
}

TEST(plan, bias_clamps_and_nearest_levels) {
  const auto level = [](Mode mode, double bias, double least, double most, std::int64_t radius, int levels) {
    SamplerOptions options = plain_options(mode);
    options.level_bias = bias;
    options.min_level = least;
    options.max_level = most;
    const State state = oracle::sampler_state(options, TexelFormat::kR8, false, 256, 256, levels, {});
    FootprintBeat<kDefaultConfig> shaped;
    shaped.major_radius = shaped.minor_radius = shaped.major_radius.from_raw(radius);
    return plan<kDefaultConfig>(shaped, state);
  };
  EXPECT_EQ(level(Mode::kTrilinear, 0, 0, 15, 512, 9).level_of_detail.raw(), 2 * 256);
  EXPECT_EQ(level(Mode::kTrilinear, 0.5, 0, 15, 512, 9).level_of_detail.raw(), 2 * 256 + 128);
  EXPECT_EQ(level(Mode::kTrilinear, 0, 0, 1.25, 512, 9).level_of_detail.raw(), 256 + 64);
  EXPECT_EQ(level(Mode::kTrilinear, 0, 3.5, 15, 512, 9).level_of_detail.raw(), 3 * 256 + 128);
  EXPECT_EQ(level(Mode::kTrilinear, 0, 0, 15, 512, 2).level_of_detail.raw(), 256);
  EXPECT_EQ(level(Mode::kBilinear, 0.5, 0, 15, 512, 9).level_of_detail.raw(), 2 * 256);  // a tie: the finer level
  EXPECT_EQ(level(Mode::kNearest, 0.50390625, 0, 15, 512, 9).level_of_detail.raw(), 3 * 256);
  EXPECT_EQ(level(Mode::kNearest, 0, 0, 15, 512, 9).linear.raw(), 0);
  EXPECT_EQ(level(Mode::kNearest, 0, 0, 15, 128, 9).linear.raw(), 1);  // magnifies: magnify is linear
  EXPECT_EQ(level(Mode::kTrilinear, -16, 0, 15, 512, 9).level_of_detail.raw(), 0);
}

}  // namespace
}  // namespace feline
