// SPDX-License-Identifier: Apache-2.0
// Invariants 1, 2, 6 and 7 of the design, of the whole unit, for every kind of lookup, sampler and texture.
#include "tests/support/invariants.h"

#include <gtest/gtest.h>

#include "model/shortcuts.h"
#include "tests/support/describe.h"

namespace feline {
namespace {

// The far side of the wrap modes must not let a border colour in.
SamplerOptions options_without_border(Random& random) {
  SamplerOptions options = random_options(random);
  if (options.wrap_s == Wrap::kClampToBorder) options.wrap_s = Wrap::kMirroredRepeat;
  if (options.wrap_t == Wrap::kClampToBorder) options.wrap_t = Wrap::kClampToEdge;
  return options;
}

bool saturates(float coordinate, std::int64_t wrap) {
  const auto mode = static_cast<Wrap>(wrap);
  const bool clamps = mode == Wrap::kClampToEdge || mode == Wrap::kClampToBorder;
  return clamps && std::isfinite(coordinate) && std::abs(coordinate) >= 0x1p19F;
}

std::int64_t status_of(const Lookup& lookup, const State& state) {
  const bool coordinates = std::isfinite(lookup.s) && std::isfinite(lookup.t);
  const bool derivatives = std::isfinite(lookup.dsdx) && std::isfinite(lookup.dtdx) && std::isfinite(lookup.dsdy) &&
                           std::isfinite(lookup.dtdy);
  const double texels =
      std::max({std::abs(lookup.dsdx * state.width.value()), std::abs(lookup.dsdy * state.width.value()),
                std::abs(lookup.dtdx * state.height.value()), std::abs(lookup.dtdy * state.height.value())});
  // Feline's modes round to nearest, the others outward.
  const bool nearest = state.mode.raw() >= static_cast<int>(Mode::kSimple);
  const bool unbounded = nearest ? texels >= 127.5 * 0x1p63 : texels > 127 * 0x1p63;
  const bool overflow =
      saturates(lookup.s, state.wrap_s.raw()) || saturates(lookup.t, state.wrap_t.raw()) || (derivatives && unbounded);
  return (coordinates ? 0 : kCoordinateNotFinite) | (derivatives ? 0 : kDerivativeNotFinite) |
         (overflow ? kOverflow : 0);
}

// Every pair of float classes in every pair of operands; calls check(lookup).
template <typename Check>
void for_each_pair_of_classes(Check check) {
  for (int first = 0; first < 6; ++first) {
    for (int second = first + 1; second < 6; ++second) {
      for (const auto a : kFloatLattice) {
        for (const auto b : kFloatLattice) {
          std::array<float, 6> operand{0.3F, 0.8F, 0.05F, -0.01F, 0.02F, 0.011F};
          operand[static_cast<std::size_t>(first)] = float_of(a);
          operand[static_cast<std::size_t>(second)] = float_of(b);
          check(Lookup{operand[0], operand[1], operand[2], operand[3], operand[4], operand[5]});
          if (::testing::Test::HasFatalFailure()) return;
        }
      }
    }
  }
}

void expect_constant(const Lookup& lookup, const State& state, const TestScene& scene) {
  const Observation seen = observe(lookup, state, scene);
  for (std::size_t c = 0; c < 4; ++c) {
    ASSERT_EQ(seen.low[c], seen.high[c]);
    ASSERT_EQ(seen.pixel.colour[c].raw(), 16 * seen.low[c]) << one_line(lookup) << " " << one_line(state);
  }
  const auto& texels = scene.texture.levels[0].texels;
  if (scene.texture.srgb) return;
  ASSERT_EQ(seen.pixel.colour[0].raw(), 256 * texels[0]) << one_line(lookup);
}

// Invariant 1: 1,000,000 lookups into 54 constant textures.
TEST(invariants, constant_texture_comes_back_exactly) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_invariants.constant");
  const auto scenes = make_scenes(random, Content::kConstant);
  for (int i = 0; i < 1000000 && !HasFatalFailure(); ++i) {
    const TestScene& scene = pick(random, scenes);
    expect_constant(lookup_into(random, scene), state_into(options_without_border(random), scene), scene);
  }
}

TEST(invariants, constant_texture_lattice) {
  Random random = random_for("model_invariants.constant_lattice");
  const auto scenes = make_scenes(random, Content::kConstant);
  for_each_pair_of_classes([&](const Lookup& lookup) {
    const TestScene& scene = pick(random, scenes);
    expect_constant(lookup, state_into(options_without_border(random), scene), scene);
  });
}

void expect_bounds_and_status(const Lookup& lookup, const State& state, const TestScene& scene, int tag) {
  const Observation seen = observe(lookup, state, scene, tag);
  const auto where = [&] { return one_line(lookup) + " " + one_line(state) + " " + one_line(seen.pixel); };
  // 2: within the texels touched. 6: count and weights. 7: status, and nobody else's tag.
  for (std::size_t c = 0; c < 4; ++c) {
    ASSERT_LE(16 * seen.low[c], seen.pixel.colour[c].raw()) << where();
    ASSERT_GE(16 * seen.high[c], seen.pixel.colour[c].raw()) << where();
  }
  ASSERT_GE(seen.probes, 1) << where();
  ASSERT_LE(seen.probes, state.max_probes.raw()) << where();
  ASSERT_EQ(seen.probes, seen.plan.probes.raw()) << where();
  ASSERT_EQ(seen.weights, 256) << where();
  ASSERT_EQ(seen.pixel.status.raw(), status_of(lookup, state)) << where();
  ASSERT_EQ(seen.pixel.tag.raw(), tag) << where();
  if ((status_of(lookup, state) & kDerivativeNotFinite) != 0) {
    ASSERT_EQ(seen.probes, 1) << where();
    ASSERT_EQ(seen.group.exponent.raw(), 63) << where();
  }
}

// Invariants 2, 6 and 7: 1,000,000 lookups of every kind into noise and into texels of 0 and 255 only.
TEST(invariants, bounds_weights_and_status) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_invariants.bounds");
  auto scenes = make_scenes(random, Content::kNoise);
  for (auto& scene : make_scenes(random, Content::kExtremes)) scenes.push_back(std::move(scene));
  for (int i = 0; i < 1000000 && !HasFatalFailure(); ++i) {
    const TestScene& scene = pick(random, scenes);
    expect_bounds_and_status(lookup_into(random, scene), state_into(random_options(random), scene), scene, i & 0xffff);
  }
}

// Invariant 7: a lookup of any float classes leaves nothing behind in a unit that keeps what it worked with: a tame
// lookup before it and after it gives the pixel that a unit of its own gives, and so does the lookup itself, twice.
TEST(invariants, lattice_of_float_classes_leaves_nothing_behind) {
  Random random = random_for("model_invariants.lattice");
  const auto scenes = make_scenes(random, Content::kNoise);
  for_each_pair_of_classes([&](const Lookup& lookup) {
    const TestScene& scene = pick(random, scenes);
    const State state = state_into(random_options(random), scene);
    const Lookup tame = tame_lookup(random, 64, 64);
    ShortcutUnit<kDefaultConfig, const TextureMemory> unit(state, scene.memory);
    for (const Lookup& each : {tame, lookup, lookup, tame}) {
      const Pixel alone = observe(each, state, scene, 6).pixel;
      ASSERT_TRUE(same(unit.sample(make_request<kDefaultConfig>(each, 6)), alone))
          << one_line(each) << " around " << one_line(lookup) << " " << one_line(state);
    }
    expect_bounds_and_status(lookup, state, scene, 6);
  });
}

// Invariant 7, in values: NaN reads as 0, an infinite coordinate as the far edge or 0, an unbounded footprint as the
// coarsest level.
TEST(invariants, what_non_finite_operands_read) {
  Random random(3);
  const TestScene scene = make_scene(random, 32, 32, TexelFormat::kR8, false, Content::kNoise);
  SamplerOptions options = plain_options(Mode::kTable);
  const auto red = [&](const Lookup& lookup) {
    return observe(lookup, state_into(options, scene), scene).pixel.colour[0].raw();
  };
  const float nan = float_of(0x7fc00000);
  const float infinity = float_of(0x7f800000);
  EXPECT_EQ(red({nan, 0.4F, 0.01F, 0, 0, 0.01F}), red({0, 0.4F, 0.01F, 0, 0, 0.01F}));
  EXPECT_EQ(red({infinity, 0.4F, 0.01F, 0, 0, 0.01F}), red({0, 0.4F, 0.01F, 0, 0, 0.01F}));
  options.wrap_s = Wrap::kClampToEdge;
  EXPECT_EQ(red({infinity, 0.4F, 0.01F, 0, 0, 0.01F}), red({1, 0.4F, 0.01F, 0, 0, 0.01F}));
  EXPECT_EQ(red({-infinity, 0.4F, 0.01F, 0, 0, 0.01F}), red({0, 0.4F, 0.01F, 0, 0, 0.01F}));
  const auto coarsest = 256 * std::int64_t{scene.texture.levels.back().texels[0]};
  EXPECT_EQ(red({0.3F, 0.4F, nan, 0, 0, 0.01F}), coarsest);
  EXPECT_EQ(red({0.3F, 0.4F, 0.01F, 0, -infinity, 0.01F}), coarsest);
  EXPECT_EQ(red({0.3F, 0.4F, 0x1p127F, 0, 0, 0x1p127F}), coarsest);
}

}  // namespace
}  // namespace feline
