// SPDX-License-Identifier: Apache-2.0
// Invariant 5 of the design: a uniformly growing footprint never gets a lower level of detail, exactly in the isotropic
// modes, and in the others never by more than fall_bound (tests/support/monotonic.h, with its proof).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/describe.h"
#include "tests/support/invariants.h"
#include "tests/support/monotonic.h"
#include "tests/support/oracle.h"

namespace feline {
namespace {

Lookup grown(Lookup lookup, double factor) {
  for (float* value : {&lookup.dsdx, &lookup.dtdx, &lookup.dsdy, &lookup.dtdy})
    *value = static_cast<float>(*value * factor);
  return lookup;
}

double random_growth(Random& random) {
  switch (random.below(4)) {
    case 0: return 1 + std::exp2(-random.real(1, 23));
    case 1: return 1 + static_cast<double>(random.between(0, 4)) * 0x1p-23;
    case 2: return random.real(1, 1.1);
    default: return random.one_in(8) ? std::exp2(random.real(0, 100)) : random.real(1, 4);
  }
}

struct Levels {
  std::int64_t base;     // before bias and clamps
  std::int64_t sampled;  // by plan
};

Levels levels_of(const Lookup& lookup, const State& state) {
  const auto request = make_request<kDefaultConfig>(lookup, 0);
  const auto shaped = footprint<kDefaultConfig>(group<kDefaultConfig>(request, state), state);
  return {level_before_clamps(shaped, state), plan<kDefaultConfig>(shaped, state).level_of_detail.raw()};
}

SamplerOptions options_of(Random& random, Mode mode) {
  SamplerOptions options = random_options(random);
  options.mode = mode;
  if (random.one_in(2)) options.probes = random.pick(std::array{kExact, kHighQuality, kHighEfficiency});
  return options;
}

constexpr std::array<std::array<int, 2>, 5> kSizes{{{16384, 16384}, {256, 256}, {1000, 37}, {1, 16384}, {5, 7}}};

State random_state(Random& random, Mode mode) {
  const auto& [width, height] = random.pick(kSizes);
  int levels = 1;
  while ((std::max(width, height) >> levels) > 0) ++levels;
  return oracle::sampler_state(options_of(random, mode), TexelFormat::kR8, false, width, height, levels, {});
}

// Footprints that a factor might take over an edge: nearly circles, nearly parallel, tame, directed and wild.
Lookup random_lookup(Random& random, const State& state) {
  const int width = static_cast<int>(state.width.raw());
  const int height = static_cast<int>(state.height.raw());
  if (random.one_in(4)) {  // one vector whose components are as 3 to 8, where the printed length falls
    const double u = std::exp2(random.real(0, 1));
    const double v = u * random.real(0.36, 0.39);
    return {0.5F, 0.5F, static_cast<float>(u / width), static_cast<float>(v / height), 0, 0};
  }
  if (random.one_in(3)) {
    const double size = std::exp2(random.real(-3, 12));
    const double angle = random.real(0, 6.2832);
    const double ratio = random.one_in(2) ? random.real(0.98, 1.02) : 1 / random.real(1, 9);
    const double skew = random.one_in(2) ? random.real(1.5, 1.65) : random.real(0, 0.3);
    return {0.5F,
            0.5F,
            static_cast<float>(size * std::cos(angle) / width),
            static_cast<float>(size * std::sin(angle) / height),
            static_cast<float>(size * ratio * std::cos(angle + skew) / width),
            static_cast<float>(size * ratio * std::sin(angle + skew) / height)};
  }
  return any_lookup(random, width, height);
}

// 1,000,000 pairs: neither the level before clamps nor the one sampled ever falls, bias and clamps included.
TEST(invariants, isotropic_level_never_falls) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_invariants.isotropic_level_never_falls");
  for (int i = 0; i < 1000000; ++i) {
    const State state =
        random_state(random, random.pick(std::array{Mode::kNearest, Mode::kBilinear, Mode::kTrilinear}));
    const Lookup lookup = random_lookup(random, state);
    const Lookup larger = grown(lookup, random_growth(random));
    const Levels before = levels_of(lookup, state);
    const Levels after = levels_of(larger, state);
    ASSERT_GE(after.base, before.base) << one_line(lookup) << " " << one_line(larger) << " " << one_line(state);
    ASSERT_GE(after.sampled, before.sampled) << one_line(lookup) << " " << one_line(larger) << " " << one_line(state);
  }
}

// 1,000,000 pairs a mode. The worst falls seen are printed; the bounds are proved.

void expect_bounded_falls(Mode mode) {
  Random random = random_for("model_invariants.falls" + mode_name(mode));
  double worst = 0;
  double worst_of_bound = 0;
  double worst_exact = 0;
  int falls = 0;
  for (int i = 0; i < 1000000; ++i) {
    const State state = random_state(random, mode);
    const Lookup lookup = random_lookup(random, state);
    const Lookup larger = grown(lookup, random_growth(random));
    const double fall = static_cast<double>(levels_of(lookup, state).base - levels_of(larger, state).base) / 256;
    const double bound = fall_bound(state);
    ASSERT_LE(fall, bound) << one_line(lookup) << " " << one_line(larger) << " " << one_line(state);
    if (fall > 0) ++falls;
    worst = std::max(worst, fall);
    worst_of_bound = std::max(worst_of_bound, fall / bound);
    if (state.probe_rounding.raw() == 0) worst_exact = std::max(worst_exact, fall);
  }
  std::printf("%s: worst fall %.4f octaves (%.4f with rounding to nearest), %.0f %% of its bound; %d of 1000000 fall\n",
              mode_name(mode).c_str(), worst, worst_exact, 100 * worst_of_bound, falls);
}

TEST(invariants, ext_level_falls_within_its_bound) {
  const SeedTrace trace(__FILE__, __LINE__);
  expect_bounded_falls(Mode::kExt);
}

TEST(invariants, simple_level_falls_within_its_bound) {
  const SeedTrace trace(__FILE__, __LINE__);
  expect_bounded_falls(Mode::kSimple);
}

TEST(invariants, table_level_falls_within_its_bound) {
  const SeedTrace trace(__FILE__, __LINE__);
  expect_bounded_falls(Mode::kTable);
}

// With the paper's exact parameters: what the bounds are.
TEST(invariants, fall_bounds_of_the_exact_parameters) {
  const auto bound = [](Mode mode) {
    return fall_bound(oracle::sampler_state(plain_options(mode), TexelFormat::kR8, false, 256, 256, 9, {}));
  };
  EXPECT_EQ(bound(Mode::kTrilinear), 0);
  EXPECT_LT(bound(Mode::kExt), 1.03);
  EXPECT_LT(bound(Mode::kSimple), 0.86);
  EXPECT_LT(bound(Mode::kTable), 1.30);
}

// Every pair of float classes among the derivatives, grown by factors from 1 + 2^-23 to 3: no class breaks the order.
TEST(invariants, isotropic_lattice) {
  const State state = oracle::sampler_state(plain_options(Mode::kTrilinear), TexelFormat::kR8, false, 16384, 3, 15, {});
  for (int first = 0; first < 4; ++first) {
    for (int second = first + 1; second < 4; ++second) {
      for (const auto a : kFloatLattice) {
        for (const auto b : kFloatLattice) {
          std::array<float, 4> d{0.001F, -0.002F, 0.0005F, 0};
          d[static_cast<std::size_t>(first)] = float_of(a);
          d[static_cast<std::size_t>(second)] = float_of(b);
          Lookup lookup{0, 0, d[0], d[1], d[2], d[3]};
          for (const double factor : {1 + 0x1p-23, 1.01, 127.0 / 126, 3.0}) {
            const Lookup larger = grown(lookup, factor);
            ASSERT_GE(levels_of(larger, state).base, levels_of(lookup, state).base) << one_line(lookup);
            lookup = larger;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace feline
