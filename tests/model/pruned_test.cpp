// SPDX-License-Identifier: Apache-2.0
// Units without some of the parts: what they lack is flagged, everything else is the full unit's, bit by bit.
#include <gtest/gtest.h>

#include "model/make_sampler.h"
#include "model/unit.h"
#include "tests/support/describe.h"
#include "tests/support/lookups.h"
#include "tests/support/pruned_configs.h"
#include "tests/support/samplers.h"

namespace feline {
namespace {

struct Seen {
  std::int64_t lookups = 0;
  std::int64_t refused = 0;
  std::int64_t flagged = 0;
  std::int64_t equal = 0;
};

// Of options that a configuration may have, more than chance would give.
template <Config kConfig>
SamplerOptions likely_options(Random& random) {
  SamplerOptions options = random_options(random);
  if (random.one_in(3)) return options;
  options.mode = supported_mode(kConfig.features, options.mode);
  options.wrap_s = supported_wrap(kConfig.features, options.wrap_s);
  options.wrap_t = supported_wrap(kConfig.features, options.wrap_t);
  if (!kConfig.features.gaussian) options.kernel = Kernel::kBilinear;
  if (!kConfig.features.factors) options.probes = kExact;
  return options;
}

template <Config kConfig>
Seen compare_with_full_unit(const char* name) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for(name);
  auto scenes = make_scenes(random, Content::kNoise);
  for (TestScene& scene : scenes) {
    // Half of the textures are opaque.
    if (scene.texture.format != TexelFormat::kRgba8 || random.one_in(2)) continue;
    for (MipLevel& level : scene.texture.levels) {
      for (std::size_t i = 3; i < level.texels.size(); i += 4) level.texels[i] = 255;
    }
    scene.memory = layout_texture(scene.texture);
  }
  Seen seen;
  for (int i = 0; i < 100000; ++i) {
    const TestScene& scene = scenes[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())))];
    const SamplerOptions options = likely_options<kConfig>(random);
    const auto full = make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
    const Lookup lookup = any_lookup(random, scene.texture.levels[0].width, scene.texture.levels[0].height);
    ++seen.lookups;
    SamplerState<kConfig> own;
    try {
      own = make_sampler<kConfig>(options, scene.texture, scene.memory);
    } catch (const SamplerError&) {
      ++seen.refused;
      continue;
    }
    const auto want = sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, i), full, scene.memory);
    const auto got = sample<kConfig>(make_request<kConfig>(lookup, i), own, scene.memory);
    if ((got.status.raw() & kUnsupported) != 0) {
      ++seen.flagged;
      continue;
    }
    ++seen.equal;
    EXPECT_EQ(got.tag.raw(), want.tag.raw());
    EXPECT_EQ(got.status.raw(), want.status.raw());
    for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(got.colour[c].raw(), want.colour[c].raw()) << "channel " << c;
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << name << ", lookup " << i << ": "
                    << mismatch(want, want, make_request<kDefaultConfig>(lookup, i), full);
      break;
    }
  }
  return seen;
}

// Whatever is drawn: enough of it must be seen on either side for the comparison to mean something.
void expect_both_sides(const Seen& seen) {
  EXPECT_GT(seen.equal, 200);
  EXPECT_GT(seen.flagged, 200);
}

TEST(pruned, a_unit_of_simple_feline_is_never_silently_wrong) {
  const Seen seen = compare_with_full_unit<kSimpleUnit>("model_pruned.simple");
  expect_both_sides(seen);
  EXPECT_GT(seen.refused, 0);
}
TEST(pruned, a_table_with_holes_is_never_silently_wrong) {
  expect_both_sides(compare_with_full_unit<kHoledTableUnit>("model_pruned.table"));
}
TEST(pruned, a_plain_unit_is_never_silently_wrong) {
  expect_both_sides(compare_with_full_unit<kPlainUnit>("model_pruned.plain"));
}
TEST(pruned, a_unit_without_feline_is_never_silently_wrong) {
  expect_both_sides(compare_with_full_unit<kExtUnit>("model_pruned.ext"));
}

TEST(pruned, a_unit_without_two_derivatives_is_never_silently_wrong) {
  expect_both_sides(compare_with_full_unit<kCrossUnit>("model_pruned.cross"));
}

// What is left out is not only flagged: the probes are those of the rounding of 3.1 and of the whole line, and
// bilinear.
TEST(pruned, without_factors_and_gaussian_everything_is_exact) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_pruned.exact");
  const auto scenes = make_scenes(random, Content::kNoise);
  int flagged = 0;
  for (int i = 0; i < 100000; ++i) {
    const TestScene& scene = scenes[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())))];
    SamplerOptions options = random_options(random);
    const Lookup lookup = any_lookup(random, scene.texture.levels[0].width, scene.texture.levels[0].height);
    const auto own = make_sampler<kExactUnit>(options, scene.texture, scene.memory);
    const bool asks = options.probes.rounding != ProbeRounding::kNearest ||
                      own.length_factor.raw() != decltype(own.length_factor)::kFormatOf.one() ||
                      options.kernel != Kernel::kBilinear;
    options.probes = kExact;
    options.kernel = Kernel::kBilinear;
    const auto exact = make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
    const auto got = sample<kExactUnit>(make_request<kExactUnit>(lookup, i), own, scene.memory);
    const auto request = make_request<kDefaultConfig>(lookup, i);
    const auto want = sample<kDefaultConfig>(request, exact, scene.memory);
    ASSERT_EQ(got.status.raw(), want.status.raw() | unsupported_if(asks));
    flagged += asks ? 1 : 0;
    for (std::size_t c = 0; c < 4; ++c) {
      ASSERT_EQ(got.colour[c].raw(), want.colour[c].raw()) << mismatch(want, want, request, exact);
    }
  }
  EXPECT_GT(flagged, 10000);
  EXPECT_LT(flagged, 90000);
}

}  // namespace
}  // namespace feline
