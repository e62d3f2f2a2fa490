// SPDX-License-Identifier: Apache-2.0
// Configurations from profiles: the least that a lookup needs, no less and no more.
#include "testbench/prune/prune.h"

#include <gtest/gtest.h>

#include <limits>

#include "model/make_sampler.h"
#include "model/unit.h"
#include "testbench/prune/observe.h"
#include "tests/support/lookups.h"
#include "tests/support/pruned_configs.h"
#include "tests/support/samplers.h"

namespace feline {
namespace {

Profile profile_of(const Lookup& lookup, const SamplerOptions& options, const TestScene& scene,
                   const ProfiledTexture& texture) {
  Profile profile;
  const auto sampler = make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
  observe(profile, "test", std::span(&lookup, 1), sampler, scene.memory, texture);
  return profile;
}

// A lookup is flagged if and only if its own profile asks for what the unit has not.
template <Config kConfig>
void expect_flags_where_profiles_say(const char* name) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for(name);
  const auto scenes = make_scenes(random, Content::kExtremes);
  std::vector<ProfiledTexture> textures;
  for (const TestScene& scene : scenes) textures.push_back(profiled_texture("test", scene.texture));
  int inside = 0;
  int outside = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto number = static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())));
    const TestScene& scene = scenes[number];
    SamplerOptions options = random_options(random);
    if (!random.one_in(4)) {
      options.mode = supported_mode(kConfig.features, options.mode);
      options.wrap_s = supported_wrap(kConfig.features, options.wrap_s);
      options.wrap_t = supported_wrap(kConfig.features, options.wrap_t);
      if (!kConfig.features.gaussian) options.kernel = Kernel::kBilinear;
      if (!kConfig.features.factors) options.probes = kExact;
    }
    const Lookup lookup = any_lookup(random, scene.texture.levels[0].width, scene.texture.levels[0].height);
    const Config needed = pruned_config(profile_of(lookup, options, scene, textures[number]));
    ASSERT_TRUE(fault_of(needed).field.empty()) << fault_of(needed).field;
    ASSERT_TRUE(is_within(needed, kDefaultConfig));
    SamplerState<kConfig> own;
    try {
      own = make_sampler<kConfig>(options, scene.texture, scene.memory);
    } catch (const SamplerError&) {
      EXPECT_FALSE(is_within(needed, kConfig));
      continue;
    }
    const auto pixel = sample<kConfig>(make_request<kConfig>(lookup, i), own, scene.memory);
    const bool flagged = (pixel.status.raw() & kUnsupported) != 0;
    ASSERT_EQ(flagged, !is_within(needed, kConfig)) << "lookup " << i << " needs\n" << unit_header(needed);
    (flagged ? outside : inside) += 1;
  }
  EXPECT_GT(inside, 40);
  EXPECT_GT(outside, 40);
}

TEST(prune, simple_unit_flags_what_profiles_say) { expect_flags_where_profiles_say<kSimpleUnit>("prune.simple"); }
TEST(prune, holed_table_flags_what_profiles_say) { expect_flags_where_profiles_say<kHoledTableUnit>("prune.table"); }
TEST(prune, plain_unit_flags_what_profiles_say) { expect_flags_where_profiles_say<kPlainUnit>("prune.plain"); }
TEST(prune, cross_unit_flags_what_profiles_say) { expect_flags_where_profiles_say<kCrossUnit>("prune.cross"); }
TEST(prune, ext_unit_flags_what_profiles_say) { expect_flags_where_profiles_say<kExtUnit>("prune.ext"); }

TestScene grey_scene(int side, TexelFormat format) {
  Random random = random_for("prune.grey");
  return make_scene(random, side, side, format, false, Content::kNoise);
}

// One lookup of 4 x 2 texels along the axes: what there is to know of it by hand.
TEST(prune, keeps_what_one_lookup_needs) {
  const TestScene scene = grey_scene(64, TexelFormat::kR8);
  SamplerOptions options;
  options.mode = Mode::kSimple;
  options.wrap_s = options.wrap_t = Wrap::kMirroredRepeat;
  const Lookup lookup{0.3F, 0.4F, 4.0F / 64, 0, 0, 2.0F / 64};
  const Config config = pruned_config(profile_of(lookup, options, scene, profiled_texture("test", scene.texture)));
  // 2 * 4/2 - 1 = 3 probes, in a radius of 2 texels: exactly level 1.
  Features features = no_features();
  features.simple_feline = features.mirrored_repeat = features.r8 = features.linear_texels = true;
  features.dudx = features.dvdy = true;
  EXPECT_EQ(config.features, features);
  EXPECT_EQ(config.max_probes, 3);
  EXPECT_EQ(config.max_levels, 2);
  EXPECT_EQ(config.max_size_log2, 6);
  EXPECT_EQ(FormatSet(config).position_fraction, Formats<kDefaultConfig>::kPositionFraction);
  EXPECT_EQ(config.exponent_bits, 2);  // 4 texels are 64 * 2^-4
  auto rows = decltype(config.weight_rows)::none();
  rows.add(8);  // fProbes 3: (3 - 1) * 4
  EXPECT_EQ(config.weight_rows, rows);
  EXPECT_EQ(config.table_cells, decltype(config.table_cells)::none());
}

// NaN leaves no bound: the unit needs du/dx and dv/dy to say so.
TEST(prune, keeps_what_a_footprint_without_bound_needs) {
  const TestScene scene = grey_scene(64, TexelFormat::kR8);
  SamplerOptions options;
  options.mode = Mode::kSimple;
  Lookup lookup{0.3F, 0.4F, 0, 0, 0, 0};
  lookup.dtdx = std::numeric_limits<float>::quiet_NaN();
  const Config config = pruned_config(profile_of(lookup, options, scene, profiled_texture("test", scene.texture)));
  EXPECT_TRUE(config.features.dudx && config.features.dvdx && config.features.dvdy);
  EXPECT_FALSE(config.features.dudy);
  EXPECT_EQ(config.exponent_bits, kDefaultConfig.exponent_bits);
}

// Positions of a narrower unit have fewer fraction bits, and so reach as many textures with fewer bits.
TEST(prune, a_range_is_in_the_units_own_fraction) {
  const TestScene scene = grey_scene(64, TexelFormat::kR8);
  SamplerOptions options;
  options.mode = Mode::kSimple;
  options.wrap_s = options.wrap_t = Wrap::kClampToEdge;
  const Profile plain =
      profile_of({0.5F, 0.5F, 1.0F / 64, 0, 0, 1.0F / 64}, options, scene, profiled_texture("test", scene.texture));
  for (const int subtexel_bits : {5, 8}) {
    Config full;
    full.subtexel_bits = subtexel_bits;
    Profile profile = plain;
    // Seven textures away, and what saturates anyway.
    profile[Reach::kPositionBitsS] = {{FormatSet(full).position_fraction + 3, 1},
                                      {FormatSet(full).position_fraction + FormatSet(full).saturation_log2 + 1, 1}};
    profile[Reach::kPositionBitsT] = {{1, 1}};
    EXPECT_EQ(pruned_config(profile, full).least_range_log2, 3) << subtexel_bits;
  }
}

// Merged profiles need what each of them needs.
TEST(prune, a_merged_profile_needs_what_its_parts_need) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("prune.merged");
  const auto scenes = make_scenes(random, Content::kNoise);
  for (int i = 0; i < 300; ++i) {
    Profile merged;
    std::vector<Config> parts;
    for (int part = 0; part < 3; ++part) {
      const TestScene& scene = scenes[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())))];
      const Lookup lookup = any_lookup(random, scene.texture.levels[0].width, scene.texture.levels[0].height);
      const Profile profile =
          profile_of(lookup, random_options(random), scene, profiled_texture("test", scene.texture));
      parts.push_back(pruned_config(profile));
      merge(merged, profile);
    }
    const Config whole = pruned_config(merged);
    EXPECT_TRUE(fault_of(whole).field.empty());
    for (const Config& part : parts) EXPECT_TRUE(is_within(part, whole));
    EXPECT_TRUE(is_within(whole, kDefaultConfig));
  }
}

TEST(prune, tells_what_is_left_out) {
  EXPECT_TRUE(left_out(kDefaultConfig).empty());
  const std::vector<std::string> lines = left_out(kSimpleUnit);
  ASSERT_FALSE(lines.empty());
  EXPECT_NE(lines.front().find("table_feline"), std::string::npos);
  EXPECT_EQ(lines.front().find("simple_feline"), std::string::npos);
  EXPECT_NE(std::ranges::find(lines, "probes: 5 of 16"), lines.end());
}

}  // namespace
}  // namespace feline
