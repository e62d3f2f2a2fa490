// SPDX-License-Identifier: Apache-2.0
// Invariants 3 and 4 of the design: scaling by 2^k, negating a gradient, swapping x and y.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/describe.h"
#include "tests/support/footprints.h"
#include "tests/support/invariants.h"
#include "tests/support/oracle.h"

namespace feline {
namespace {

Lookup scaled(Lookup lookup, int k) {
  for (float* value : {&lookup.dsdx, &lookup.dtdx, &lookup.dsdy, &lookup.dtdy}) *value = std::ldexp(*value, k);
  return lookup;
}

// Whether a radius is clamped to one texel: then the level is not the footprint's own.
bool is_clamped(const FootprintBeat<kDefaultConfig>& footprint) {
  const double texel = std::exp2(-static_cast<double>(footprint.exponent.raw()));
  return footprint.minor_radius.value() < texel || footprint.major_radius.value() < texel;
}

// Invariant 3: 1,000,000 lookups, all modes, parameters and limits. Mantissas stay, the exponent moves by exactly k,
// and so does the sampled level while nothing clamps it.
TEST(invariants, scaling_by_powers_of_two_moves_the_level_exactly) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_invariants.scaling");
  int levels_compared = 0;
  for (int i = 0; i < 1000000; ++i) {
    SamplerOptions options = random_options(random);
    options.level_bias = options.min_level = 0;
    options.max_level = 15.99609375;
    const State state = oracle::sampler_state(options, TexelFormat::kR8, false, 16384, 16384, 15, {});
    Lookup lookup = random.one_in(4) ? directed_lookup(random, 1 << 12, 1 << 10) : tame_lookup(random, 16384, 16384);
    const int k = static_cast<int>(random.between(1, random.one_in(4) ? 60 : 8));
    const auto plan_of = [&](const Lookup& from, GroupBeat<kDefaultConfig>& grouped,
                             FootprintBeat<kDefaultConfig>& shaped) {
      grouped = group<kDefaultConfig>(make_request<kDefaultConfig>(from, 0), state);
      shaped = footprint<kDefaultConfig>(grouped, state);
      return plan<kDefaultConfig>(shaped, state);
    };
    GroupBeat<kDefaultConfig> small_group;
    GroupBeat<kDefaultConfig> large_group;
    FootprintBeat<kDefaultConfig> small;
    FootprintBeat<kDefaultConfig> large;
    const auto small_plan = plan_of(lookup, small_group, small);
    const auto large_plan = plan_of(scaled(lookup, k), large_group, large);
    if (small_group.exponent.raw() + k > 63 || small_group.exponent.raw() == -64) continue;
    auto expected = small_group;
    expected.exponent = expected.exponent.from_raw(small_group.exponent.raw() + k);
    ASSERT_TRUE(same(large_group, expected)) << one_line(lookup) << " k=" << k;
    if (is_clamped(small)) continue;
    const auto base = level_before_clamps(small, state);
    if (base + 256 * k < 32 * 256) {
      ASSERT_EQ(level_before_clamps(large, state), base + 256 * k) << one_line(lookup) << " " << one_line(state);
    }
    const Mode mode = static_cast<Mode>(state.mode.raw());
    // Nearest and bilinear round the level that they sample; a level below 0 is clamped before.
    const bool one_level = mode == Mode::kNearest || mode == Mode::kBilinear;
    if (base >= 0 && base + 256 * k <= 14 * 256) {
      ASSERT_EQ(large_plan.level_of_detail.raw(), small_plan.level_of_detail.raw() + 256 * k)
          << one_line(lookup) << " " << one_line(state) << (one_level ? " one level" : "");
      ASSERT_EQ(large_plan.probes.raw(), small_plan.probes.raw()) << one_line(lookup) << " " << one_line(state);
      ++levels_compared;
    }
  }
  EXPECT_GT(levels_compared, 300000);
}

bool is_tie(const GroupBeat<kDefaultConfig>& grouped) {
  return vector_length(grouped.dudx.raw(), grouped.dvdx.raw()) == vector_length(grouped.dudy.raw(), grouped.dvdy.raw());
}

// Invariant 4: 1,000,000 lookups of every kind. The pixel stays the same, bit for bit.
TEST(invariants, negating_a_gradient_and_swapping_them_change_nothing) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_invariants.symmetry");
  const auto scenes = make_scenes(random, Content::kNoise);
  int ties = 0;
  for (int i = 0; i < 1000000; ++i) {
    const TestScene& scene = pick(random, scenes);
    const State state = state_into(random_options(random), scene);
    const Lookup lookup = lookup_into(random, scene);
    const Observation seen = observe(lookup, state, scene);
    Lookup other = lookup;
    const auto which = random.below(3);
    if (which == 0) other.dsdx = -other.dsdx, other.dtdx = -other.dtdx;
    if (which == 1) other.dsdy = -other.dsdy, other.dtdy = -other.dtdy;
    if (which == 2) {
      std::swap(other.dsdx, other.dsdy);
      std::swap(other.dtdx, other.dtdy);
    }
    const Observation mirrored = observe(other, state, scene);
    ASSERT_EQ(seen.footprint.minor_radius, mirrored.footprint.minor_radius) << one_line(lookup) << one_line(state);
    ASSERT_EQ(seen.footprint.major_radius, mirrored.footprint.major_radius) << one_line(lookup) << one_line(state);
    if (which == 2 && is_tie(seen.group)) {
      ++ties;
      continue;
    }
    ASSERT_TRUE(same(seen.pixel, mirrored.pixel)) << mismatch(mirrored.pixel, seen.pixel, lookup, other, state);
  }
  EXPECT_GT(ties, 0);
  EXPECT_LT(ties, 200000);
}

// The same over every quadruple of edge mantissas, at the footprint: vectors negate, radii stay.
TEST(invariants, symmetry_lattice) {
  constexpr std::array<int, 15> kEdges{-127, -85, -64, -45, -7, -2, -1, 0, 1, 2, 7, 32, 64, 120, 127};
  for (const Mode mode : {Mode::kTrilinear, Mode::kExt, Mode::kSimple, Mode::kTable}) {
    const State state = state_of(mode);
    const auto shape = [&](int a, int b, int c, int d) {
      return footprint<kDefaultConfig>(group_beat({a, b, c, d}, 0), state);
    };
    for (const int a : kEdges) {
      for (const int b : kEdges) {
        for (const int c : kEdges) {
          for (const int d : kEdges) {
            const auto seen = shape(a, b, c, d);
            for (const auto& other : {shape(-a, -b, c, d), shape(a, b, -c, -d), shape(c, d, a, b)}) {
              ASSERT_EQ(other.major_radius, seen.major_radius) << a << " " << b << " " << c << " " << d;
              ASSERT_EQ(other.minor_radius, seen.minor_radius) << a << " " << b << " " << c << " " << d;
              if (vector_length(a, b) == vector_length(c, d)) continue;
              const bool kept = other.major_u == seen.major_u && other.major_v == seen.major_v;
              const bool negated =
                  other.major_u.raw() == -seen.major_u.raw() && other.major_v.raw() == -seen.major_v.raw();
              ASSERT_TRUE(kept || negated) << a << " " << b << " " << c << " " << d;
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace feline
