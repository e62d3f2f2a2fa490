// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "model/unit.h"
#include "tests/testbench/prune/profiles.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

constexpr int kProfileSide = 256;

SamplerOptions in_mode(Mode mode, Wrap wrap = Wrap::kRepeat) {
  SamplerOptions options;
  options.mode = mode;
  options.wrap_s = options.wrap_t = wrap;
  return options;
}

Histogram once(std::int64_t value, std::uint64_t count = 1) { return {{value, count}}; }

// The README's example: (13, 0), (12, 5) texels a pixel. Mantissas are eighths of a texel. Lengths 13312 and 13264 of
// 1/128 are row 15 of 16; cross and dot product 4160 and 9984 are column 3 of the lower 8.
TEST(profile, one_lookup_through_the_table) {
  const TestTexture test(flat_texture(kProfileSide, kProfileSide));
  const Profile profile =
      test.profile({TexelLookup{40.5, 80.5, 13, 0, 12, 5}.in(kProfileSide, kProfileSide)}, in_mode(Mode::kTable));
  EXPECT_EQ(profile.lookups, 1U);
  EXPECT_EQ(profile.probes, 9U);
  EXPECT_EQ(profile.frames(), 1U);
  EXPECT_EQ(profile[Reach::kExponent], once(-3));
  EXPECT_EQ(profile[Reach::kDudx], once(104));
  EXPECT_EQ(profile[Reach::kDvdx], once(0));
  EXPECT_EQ(profile[Reach::kDudy], once(96));
  EXPECT_EQ(profile[Reach::kDvdy], once(40));
  EXPECT_EQ(profile[Reach::kCell], once(15 * 16 + 3));
  EXPECT_EQ(profile[Reach::kProbes], once(9));
  EXPECT_EQ(profile[Reach::kMagnified], once(0));
  EXPECT_EQ(profile[Reach::kLevel], once(1));  // the minor radius is 3.7 texels
  EXPECT_EQ(profile[Reach::kBlended], once(1));
  EXPECT_EQ(profile[Reach::kFineLevel], once(1, 9));
  EXPECT_EQ(profile[Reach::kCoarseLevel], once(2, 9));
  EXPECT_EQ(profile[Reach::kBorderTexels], once(0, 9));
  EXPECT_EQ(profile[Reach::kTranslucent], once(0, 9));
  EXPECT_EQ(profile[Reach::kStatus], once(0));
  EXPECT_EQ(profile[Reach::kMode], once(static_cast<std::int64_t>(Mode::kTable)));
  EXPECT_EQ(profile[Reach::kWidth], once(kProfileSide));
  EXPECT_EQ(profile[Reach::kPowerOfTwo], once(1));
  EXPECT_EQ(profile[Reach::kLastLevel], once(8));
}

// Without the table no cell is reached; the footprint of one texel is level 0 itself and of half a texel magnified.
TEST(profile, isotropic_lookups) {
  const TestTexture test(flat_texture(kProfileSide, kProfileSide));
  const Profile profile = test.profile({TexelLookup{40.5, 80.5, 1, 0, 0, 1}.in(kProfileSide, kProfileSide),
                                        TexelLookup{40.5, 80.5, 0.5, 0, 0, 0.5}.in(kProfileSide, kProfileSide),
                                        TexelLookup{40.5, 80.5, 4, 0, 0, 4}.in(kProfileSide, kProfileSide)},
                                       in_mode(Mode::kTrilinear));
  EXPECT_EQ(profile.probes, 3U);
  EXPECT_TRUE(profile[Reach::kCell].empty());
  EXPECT_EQ(profile[Reach::kExponent], (Histogram{{-7, 1}, {-6, 1}, {-4, 1}}));
  EXPECT_EQ(profile[Reach::kMagnified], (Histogram{{0, 2}, {1, 1}}));
  EXPECT_EQ(profile[Reach::kLevel], (Histogram{{0, 2}, {2, 1}}));
  EXPECT_EQ(profile[Reach::kBlended], once(0, 3));
  EXPECT_EQ(profile[Reach::kWeightRow], once(0, 3));
  EXPECT_EQ(profile[Reach::kHalfStepBitsS], once(0, 3));
  EXPECT_TRUE(profile[Reach::kCoarseLevel].empty());
  // 40.5/256 is less than 1/4: two bits fewer than the fraction has.
  EXPECT_EQ(profile[Reach::kPositionBitsS], once(22, 3));
  EXPECT_EQ(profile[Reach::kProbeBitsT], once(23, 3));
}

// Texels (10, 2) to (11, 3) lie in the third tile; (15, 2) to (16, 3) in the fourth and fifth.
TEST(profile, memory_lines) {
  const TestTexture test(flat_texture(kProfileSide, kProfileSide));
  Profile profile;
  const auto look = [&](double u, double v) {
    test.observe_in(profile, {TexelLookup{u, v, 0.5, 0, 0, 0.5}.in(kProfileSide, kProfileSide)},
                    in_mode(Mode::kBilinear));
  };
  look(10.5, 2.5);
  const TextureUse& use = test.use_in(profile);
  EXPECT_EQ(use.touched.count(), 1U);
  EXPECT_TRUE(use.touched.contains(2));
  EXPECT_EQ(use.blocks[2], 4U);
  look(15.75, 2.5);
  EXPECT_EQ(use.touched.count(), 3U);
  EXPECT_TRUE(use.touched.contains(3));
  EXPECT_TRUE(use.touched.contains(4));
  EXPECT_EQ(use.blocks[4], 2U);
  EXPECT_EQ(std::accumulate(use.blocks.begin(), use.blocks.end(), std::uint64_t{0}), 8U);
  EXPECT_EQ(use.touched.size(), test.memory.lines());
}

TEST(profile, shapes_of_textures) {
  const TestTexture test(flat_texture(1000, 3));
  const TextureUse& use = test.profiled.unread;
  EXPECT_EQ(use.touched.size(), test.memory.lines());
  for (int level = 0; level < use.levels; ++level) {
    EXPECT_EQ(use.first_line(level), static_cast<std::size_t>(test.memory.level_base[static_cast<std::size_t>(level)]));
  }
  EXPECT_EQ(use.tile_columns(0), 250);
  EXPECT_EQ(use.block_shift(), 2);
  EXPECT_EQ(use.block_columns(), 63);
  EXPECT_EQ(use.block_rows(), 1);
  const Profile profile = test.profile({Lookup{}}, in_mode(Mode::kTable));
  EXPECT_EQ(profile[Reach::kPowerOfTwo], once(0));
  EXPECT_EQ(profile[Reach::kWidth], once(1000));
  EXPECT_EQ(profile[Reach::kHeight], once(3));
}

TEST(profile, textures_are_told_apart) {
  Texture texture = flat_texture(8, 4);
  const std::string hash = texture_hash(texture);
  EXPECT_EQ(hash.size(), 40U);
  EXPECT_EQ(texture_hash(flat_texture(8, 4)), hash);
  EXPECT_NE(texture_hash(flat_texture(4, 8)), hash);
  texture.levels.back().texels[3] = 0;
  EXPECT_NE(texture_hash(texture), hash);
  texture = flat_texture(8, 4);
  texture.levels.pop_back();
  EXPECT_NE(texture_hash(texture), hash);
}

TEST(profile, exception_classes) {
  const TestTexture test(flat_texture(kProfileSide, kProfileSide));
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Profile profile = test.profile({{kNan, 0.5F, 0, 0, 0, 0},
                                        {0.5F, 0.5F, 0, kInfinity, 0, 0},
                                        {1e9F, 0.5F, 0, 0, 0, 0},
                                        {1e9F, 0.5F, 0, 0, kNan, 0},
                                        {0.5F, 0.5F, 0, 0, 0, 0}},
                                       in_mode(Mode::kSimple, Wrap::kClampToEdge));
  EXPECT_EQ(profile[Reach::kStatus], (Histogram{{0, 1},
                                                {kCoordinateNotFinite, 1},
                                                {kDerivativeNotFinite, 1},
                                                {kOverflow, 1},
                                                {kDerivativeNotFinite + kOverflow, 1}}));
  EXPECT_EQ(profile.count(Reach::kExponent, 63), 2U);
  EXPECT_EQ(profile.count(Reach::kDudx, 127), 2U);
}

TEST(profile, borders_and_alpha) {
  const TestTexture opaque(flat_texture(kProfileSide, kProfileSide));
  SamplerOptions options = in_mode(Mode::kBilinear, Wrap::kClampToBorder);
  options.wrap_t = Wrap::kRepeat;
  // Wholly outside; across the left edge; inside.
  const std::vector<Lookup> lookups{TexelLookup{-20, 10.5, 0, 0, 0, 0}.in(kProfileSide, kProfileSide),
                                    TexelLookup{0, 10.5, 0, 0, 0, 0}.in(kProfileSide, kProfileSide),
                                    TexelLookup{20, 10.5, 0, 0, 0, 0}.in(kProfileSide, kProfileSide)};
  Profile profile = opaque.profile(lookups, options);
  EXPECT_EQ(profile[Reach::kBorderTexels], (Histogram{{0, 1}, {2, 1}, {4, 1}}));
  EXPECT_EQ(profile[Reach::kTranslucent], (Histogram{{0, 1}, {1, 2}}));  // the border's alpha is 0
  EXPECT_EQ(profile[Reach::kWrap], (Histogram{{0, 3}, {3, 3}}));
  EXPECT_EQ(opaque.use_in(profile).touched.count(), 3U);  // of the texels 0, 19 and 20
  // Between two levels, outside of both.
  SamplerOptions blended = options;
  blended.mode = Mode::kTrilinear;
  const Profile two = opaque.profile({TexelLookup{-20, 10.5, 1.5, 0, 0, 1.5}.in(kProfileSide, kProfileSide)}, blended);
  EXPECT_EQ(two[Reach::kBlended], once(1));
  EXPECT_EQ(two[Reach::kBorderTexels], once(8));
  EXPECT_EQ(opaque.use_in(two).touched.count(), 0U);
  options.border[3] = 1;
  EXPECT_EQ(opaque.profile(lookups, options)[Reach::kTranslucent], once(0, 3));
  const TestTexture translucent(flat_texture(kProfileSide, kProfileSide, 254));
  EXPECT_EQ(translucent.profile(lookups, options)[Reach::kTranslucent], (Histogram{{0, 1}, {1, 2}}));
}

TEST(profile, sampler_values) {
  const TestTexture test(flat_texture(kProfileSide, kProfileSide));
  SamplerOptions options;
  options.probes = kHighQuality;
  options.max_probes = 5;
  options.level_bias = -1;
  options.min_level = 0.5;
  options.max_level = 3;
  options.kernel = Kernel::kGaussian;
  options.magnify = Magnify::kNearest;
  const Profile profile = test.profile(random_lookups(1, 10), options);
  EXPECT_EQ(profile[Reach::kProbeRounding], once(1, 10));
  EXPECT_EQ(profile[Reach::kLengthFactor], once(246, 10));
  EXPECT_EQ(profile[Reach::kBlurFactor], once(296, 10));
  EXPECT_EQ(profile[Reach::kInverseAliasFactor], once(222, 10));
  EXPECT_EQ(profile[Reach::kMaxProbes], once(5, 10));
  EXPECT_EQ(profile[Reach::kLevelBias], once(-256, 10));
  EXPECT_EQ(profile[Reach::kMinLevel], once(128, 10));
  EXPECT_EQ(profile[Reach::kMaxLevel], once(768, 10));
  EXPECT_EQ(profile[Reach::kKernel], once(1, 10));
  EXPECT_EQ(profile[Reach::kMagnify], once(0, 10));
  EXPECT_LE(profile[Reach::kProbes].rbegin()->first, 5);
}

// Each count again in a loop of its own, by the unit's beats alone and one lookup after the other.
TEST(profile, agrees_with_counting_by_hand) {
  const TestTexture test(flat_texture(96, 160));
  const std::vector<Lookup> lookups = random_lookups(2, 20000);  // two parts, on two processors
  for (const Mode mode : {Mode::kExt, Mode::kSimple, Mode::kTable}) {
    const SamplerOptions options = in_mode(mode, Wrap::kMirroredRepeat);
    const Profile profile = test.profile(lookups, options);
    const auto sampler = make_sampler<kDefaultConfig>(options, test.texture, test.memory);
    Histogram probes, rows, dudy, half_steps, fine;
    std::set<std::int64_t> lines;
    std::uint64_t walked = 0;
    for (const Lookup& lookup : lookups) {
      sample<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 0), sampler, test.memory,
                             [&]<typename Beat>(const Beat& beat) {
                               if constexpr (std::is_same_v<Beat, GroupBeat<kDefaultConfig>>) ++dudy[beat.dudy.raw()];
                               if constexpr (std::is_same_v<Beat, PlanBeat<kDefaultConfig>>) {
                                 ++probes[beat.probes.raw()];
                                 ++rows[beat.weight_row.raw()];
                                 int bits = 0;
                                 for (std::int64_t rest = std::abs(beat.half_step_t.raw()); rest != 0; rest /= 2)
                                   ++bits;
                                 ++half_steps[bits];
                               }
                               if constexpr (std::is_same_v<Beat, AddressBeat<kDefaultConfig>>) {
                                 ++walked;
                                 ++fine[beat.level.raw()];
                                 for (const auto& line : beat.fine_line) lines.insert(line.raw());
                                 for (const auto& line : beat.coarse_line) {
                                   if (beat.coarse_used.raw() != 0) lines.insert(line.raw());
                                 }
                               }
                             });
    }
    EXPECT_EQ(profile.lookups, lookups.size());
    EXPECT_EQ(profile.probes, walked);
    EXPECT_EQ(profile[Reach::kProbes], probes);
    EXPECT_EQ(profile[Reach::kWeightRow], rows);
    EXPECT_EQ(profile[Reach::kDudy], dudy);
    EXPECT_EQ(profile[Reach::kHalfStepBitsT], half_steps);
    EXPECT_EQ(profile[Reach::kFineLevel], fine);
    const TextureUse& use = test.use_in(profile);
    EXPECT_EQ(use.touched.count(), lines.size());
    for (const std::int64_t line : lines) EXPECT_TRUE(use.touched.contains(static_cast<std::size_t>(line)));
    for (const Reach reach : {Reach::kExponent, Reach::kLevel, Reach::kStatus, Reach::kMagnified}) {
      EXPECT_EQ(total(profile[reach]), profile.lookups);
    }
    EXPECT_EQ(total(profile[Reach::kBorderTexels]), profile.probes);
    EXPECT_EQ(total(profile[Reach::kCell]), mode == Mode::kTable ? profile.lookups : 0);
  }
}

// Frames of three sources in three textures under three samplers, of which one comes twice.
struct Frames {
  TestTexture first{flat_texture(64, 64), "first"};
  TestTexture again{flat_texture(64, 64), "again"};  // the same texels under another name
  TestTexture second{flat_texture(100, 20, 7), "second"};

  void observe_frame(Profile& profile, int index) const {
    const std::vector<Lookup> lookups = random_lookups(static_cast<std::uint64_t>(index), 300);
    if (index == 0) first.observe_in(profile, lookups, in_mode(Mode::kTable), "a");
    if (index == 1) again.observe_in(profile, lookups, in_mode(Mode::kExt, Wrap::kClampToBorder), "b");
    if (index == 2) second.observe_in(profile, lookups, in_mode(Mode::kNearest, Wrap::kClampToEdge), "a");
  }
  Profile of(std::initializer_list<int> frames) const {
    Profile profile;
    for (const int index : frames) observe_frame(profile, index);
    return profile;
  }
};

Profile merged(const Profile& a, const Profile& b) {
  Profile sum = a;
  merge(sum, b);
  return sum;
}

TEST(profile, merging_is_profiling_one_after_the_other) {
  const Frames frames;
  const std::array parts{frames.of({0}), frames.of({1}), frames.of({2})};
  EXPECT_EQ(merged(parts[0], parts[1]), frames.of({0, 1}));
  EXPECT_EQ(merged(parts[1], parts[2]), frames.of({1, 2}));
  EXPECT_EQ(merged(parts[0], parts[1]), merged(parts[1], parts[0]));
  EXPECT_EQ(merged(merged(parts[0], parts[1]), parts[2]), merged(parts[0], merged(parts[1], parts[2])));
  EXPECT_EQ(merged(merged(parts[0], parts[1]), parts[2]), frames.of({2, 0, 1}));
  EXPECT_EQ(merged(parts[0], Profile{}), parts[0]);
  EXPECT_EQ(merged(Profile{}, parts[0]), parts[0]);
  const Profile all = frames.of({0, 1, 2});
  EXPECT_EQ(all.textures.size(), 2U);
  EXPECT_EQ(all.textures.at(frames.first.profiled.hash).names, (std::set<std::string>{"again", "first"}));
  EXPECT_EQ(all.sources, (std::map<std::string, std::uint64_t>{{"a", 2}, {"b", 1}}));
  // Twice is twice as often.
  EXPECT_EQ(merged(all, all).lookups, 2 * all.lookups);
  EXPECT_EQ(merged(all, all).count(Reach::kStatus, 0), 2 * all.count(Reach::kStatus, 0));
}

TEST(profile, counts_saturate) {
  Profile profile;
  profile.lookups = std::numeric_limits<std::uint64_t>::max() - 1;
  profile[Reach::kCell][7] = profile.lookups;
  const Profile sum = merged(profile, profile);
  EXPECT_EQ(sum.lookups, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(sum.count(Reach::kCell, 7), std::numeric_limits<std::uint64_t>::max());
}

TEST(profile, one_texture_has_one_shape) {
  const Frames frames;
  Profile profile = frames.of({0});
  Profile other = profile;
  other.textures.begin()->second.width = 32;
  const Profile before = profile;
  EXPECT_NE(input_error([&] { merge(profile, other); }).find("32 x 64"), std::string::npos);
  EXPECT_EQ(profile, before);
}

std::size_t entries(const Profile& profile) {
  std::size_t count = profile.sources.size();
  for (const Histogram& histogram : profile.reached) count += histogram.size();
  for (const auto& [hash, use] : profile.textures) count += use.names.size() + use.touched.size() + use.blocks.size();
  return count;
}

// Of a sequence nothing stays but counts.
TEST(profile, does_not_grow_with_the_sequence) {
  const TestTexture test(flat_texture(64, 64));
  const auto observe_frames = [&](int count) {
    Profile profile;
    for (int i = 0; i < count; ++i) {
      test.observe_in(profile, random_lookups(static_cast<std::uint64_t>(i % 2), 50), in_mode(Mode::kTable));
    }
    return profile;
  };
  const Profile two = observe_frames(2);
  const Profile many = observe_frames(200);
  EXPECT_EQ(entries(many), entries(two));
  EXPECT_EQ(many.frames(), 200U);
  EXPECT_EQ(many.lookups, 100 * two.lookups);
  EXPECT_EQ(many.count(Reach::kProbes, 1), 100 * two.count(Reach::kProbes, 1));
  // Frames that are all different fill what there is, and no more.
  Profile different;
  for (std::uint64_t i = 0; i < 200; ++i) test.observe_in(different, random_lookups(i, 50), in_mode(Mode::kTable));
  for (std::size_t i = 0; i < kReachCount; ++i) {
    for (const auto& [value, count] : different.reached[i]) {
      EXPECT_GE(value, kReachFacts[i].least) << kReachFacts[i].name;
      EXPECT_LE(value, kReachFacts[i].most) << kReachFacts[i].name;
    }
  }
}

TEST(profile, facts_fit_the_enumeration) {
  EXPECT_EQ(facts(Reach::kMode).name, "mode");
  EXPECT_EQ(facts(Reach::kLastLevel).name, "last_level");
  EXPECT_EQ(facts(Reach::kDvdy).name, "dvdy");
  EXPECT_EQ(facts(Reach::kCell).name, "cell");
  EXPECT_EQ(facts(Reach::kWeightRow).name, "weight_row");
  EXPECT_EQ(facts(Reach::kBorderTexels).name, "border_texels");
  EXPECT_EQ(facts(Reach::kStatus).name, "status");
  std::set<std::string> names;
  for (const ReachFacts& of : kReachFacts) names.insert(std::string(of.part) + "." + std::string(of.name));
  EXPECT_EQ(names.size(), kReachCount);
  // Names of sets of status bits are those of their bits.
  const ReachFacts& status = facts(Reach::kStatus);
  for (std::int64_t set = 1; set <= status.most; ++set) {
    std::string want;
    for (std::size_t bit = 0; bit < kStatusNames.size(); ++bit) {
      if ((set >> bit & 1) != 0) want += (want.empty() ? "" : "+") + std::string(kStatusNames[bit]);
    }
    EXPECT_EQ(value_name(status, set), want);
  }
}

}  // namespace
}  // namespace feline
