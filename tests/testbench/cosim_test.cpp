// SPDX-License-Identifier: Apache-2.0
// RTL against model through the bench: every scene and choice in small pictures, and every kind of texture.
#include <gtest/gtest.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <bit>

#include "testbench/cosim/close_batches.h"
#include "testbench/cosim/job.h"
#include "testbench/cosim/random_batches.h"
#include "testbench/random.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

// A lookup job that owns what it refers to.
struct Case {
  Texture texture;
  TextureMemory memory;
  std::vector<Lookup> lookups;

  CosimJob job(const SamplerOptions& options, const Timing& timing) const {
    CosimJob made;
    made.scene = "test";
    made.timing = timing;
    made.command = "feline cosim";
    made.lookups = made.batch_lookups = lookups.size();
    made.batch = [this, sampler = make_sampler<kUnit>(options, texture, memory)](std::uint64_t) {
      return Batch{sampler, &memory, lookups, 0};
    };
    return made;
  }
};

CosimResult run_case(const Case& subject, const SamplerOptions& options, const Timing& timing = {5, 0.2, 1}) {
  CosimResult result = run_job(subject.job(options, timing), make_fast_unit, {}, std::nullopt, true, nullptr);
  EXPECT_EQ(result.mismatches, 0U) << result.message;
  EXPECT_EQ(result.lookups, subject.lookups.size());
  EXPECT_EQ(result.beats[static_cast<std::size_t>(Stage::kFetch)], result.probes);
  return result;
}

Case scene_case(const Scene& scene, int width, int height) {
  Case made;
  made.texture = scene.texture();
  made.memory = layout_texture(made.texture);
  made.lookups = make_gbuffer(scene, width, height).lookups;
  return made;
}

// Noise of any size, and lookups whose footprints and positions suit it.
Case noise_case(int width, int height, TexelFormat format, bool srgb, std::uint64_t seed) {
  SplitMix64 random(seed);
  Case made;
  made.texture.format = format;
  made.texture.srgb = srgb;
  for (int k = 0; k < mip_count(width, height); ++k) {
    MipLevel level{mip_size(width, k), mip_size(height, k), {}};
    level.texels.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) *
                        static_cast<std::size_t>(bytes_per_texel(format)));
    for (auto& byte : level.texels) byte = static_cast<std::uint8_t>(random.below(256));
    made.texture.levels.push_back(std::move(level));
  }
  made.memory = layout_texture(made.texture);
  for (int i = 0; i < 400; ++i) {
    const auto near = [&](double scale) { return static_cast<float>(scale * (2 * random.unit() - 1)); };
    const double texels = 0.1 * (1 << random.below(11));
    made.lookups.push_back({near(2.5), near(2.5), near(texels / width), near(texels / height), near(texels / width / 4),
                            near(texels / height / 4)});
  }
  return made;
}

TEST(cosim, every_scene_mode_kernel_and_wrap) {
  for (const Scene& scene : scenes()) {
    const Case subject = scene_case(scene, 20, 12);
    for (std::size_t choice = 0; choice < kModeNames.size() * 2 * 4; ++choice) {
      SamplerOptions options;
      options.mode = static_cast<Mode>(choice / 8);
      options.kernel = static_cast<Kernel>(choice / 4 % 2);
      options.wrap_s = static_cast<Wrap>(choice % 4);
      options.wrap_t = static_cast<Wrap>((choice + 1) % 4);
      SCOPED_TRACE(std::string(scene.name) + ", choice " + std::to_string(choice));
      run_case(subject, options);
    }
  }
}

TEST(cosim, every_size_format_and_wrap) {
  constexpr std::array<std::array<int, 2>, 10> kSizes{
      {{1, 1}, {1, 37}, {64, 1}, {5, 3}, {33, 20}, {128, 128}, {16384, 1}, {16384, 3}, {2, 16383}, {100, 7}}};
  std::uint64_t seed = 1;
  for (const auto& [width, height] : kSizes) {
    for (std::size_t choice = 0; choice < 12; ++choice) {
      const Case subject = noise_case(width, height, static_cast<TexelFormat>(choice % 3), choice % 2 == 0, seed++);
      SamplerOptions options;
      options.wrap_s = static_cast<Wrap>(choice % 4);
      options.wrap_t = static_cast<Wrap>(choice / 3);
      options.border = {0.25, 1, 0, 0.5};
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height) + ", choice " + std::to_string(choice));
      run_case(subject, options);
    }
  }
}

TEST(cosim, parameter_sets_bias_and_level_limits) {
  const Case subject = noise_case(96, 64, TexelFormat::kRgba8, true, 7);
  for (const ProbeParameters& probes : {kExact, kHighQuality, kHighEfficiency}) {
    for (const int max_probes : {1, 2, 7, 16}) {
      SamplerOptions options;
      options.probes = probes;
      options.max_probes = max_probes;
      options.level_bias = max_probes / 4.0 - 1;
      options.min_level = max_probes == 2 ? 1.5 : 0;
      options.max_level = max_probes == 7 ? 2.25 : 15;
      options.magnify = max_probes == 1 ? Magnify::kNearest : Magnify::kLinear;
      run_case(subject, options);
    }
  }
}

CosimResult run_random(RandomBatches batches, const Timing& timing) {
  constexpr std::uint64_t kLookups = 20000;
  CosimJob job;
  job.timing = timing;
  job.command = "feline cosim";
  job.lookups = kLookups;
  job.batch_lookups = 256;
  job.batch = [&](std::uint64_t number) { return batches.make(number, kLookups); };
  CosimResult result = run_job(job, make_fast_unit, {}, std::nullopt, false, nullptr);
  EXPECT_EQ(result.mismatches, 0U) << result.message;
  EXPECT_EQ(result.lookups, kLookups);
  return result;
}

TEST(cosim, random_lookups) { EXPECT_EQ(run_random({1, 256}, {3, 0.3, 1}).resets, 0U); }

TEST(cosim, random_lookups_under_conditions_that_vary) {
  RandomBatches batches(1, 256);
  batches.vary_conditions();
  EXPECT_GT(run_random(std::move(batches), {3, 0, 1}).resets, 20U);
}

TEST(cosim, sums_that_all_but_round_the_other_way) {
  constexpr std::uint64_t kLookups = 128;
  const CloseBatches batches(1, kLookups);
  Cosimulation simulation(make_fast_unit, {5, 0, 1});
  std::uint64_t close = 0;
  std::uint64_t alpha = 0;
  for (std::size_t i = 0; i < batches.size(); ++i) {
    for (std::size_t channel = 0; channel < 4; ++channel) close += std::abs(batches.distance(i, channel)) < 64 ? 1U : 0;
    alpha += i % 2 != 0 && batches.distance(i, 3) == -1 ? 1U : 0;
    ASSERT_TRUE(simulation.run(batches[i])) << i;
  }
  // Of the rest no four texels have a step that is fine enough.
  EXPECT_GT(close, 2 * kLookups);
  // Where whole codes do not come to: borders add fractions of them.
  EXPECT_GE(alpha, kLookups / 16);
}

TEST(cosim, strips_are_of_every_length_and_some_rows_of_tiles) {
  RandomBatches batches(1, 16);
  std::uint32_t bits = 0;
  int tall = 0;
  for (std::uint64_t i = 0; i < 400; i += 2) {
    const Batch batch = batches.make(i, 8000);
    const auto width = static_cast<std::uint32_t>(batch.sampler.width.raw());
    const auto height = static_cast<std::uint32_t>(batch.sampler.height.raw());
    if (std::min(width, height) <= 4 || std::max(width, height) <= 90) continue;
    bits |= std::max(width, height);
    ++tall;
  }
  EXPECT_GT(tall, 4);
  EXPECT_EQ(bits | 1U << kUnit.max_size_log2, (2U << kUnit.max_size_log2) - 1);
}

TEST(cosim, some_textures_lie_where_the_one_before_lay) {
  RandomBatches batches(1, 16);
  int alike = 0;
  int resets = 0;
  for (std::uint64_t pair = 0; pair < 40; pair += 2) {
    const TextureMemory before = *batches.make(2 * pair, 8000).memory;
    const Batch next = batches.make(2 * pair + 2, 8000);
    const TextureMemory& after = *next.memory;
    if (after.first_line != before.first_line) continue;
    ++alike;
    resets += next.begins_with_reset ? 1 : 0;
    EXPECT_EQ(after.level_base, before.level_base);
    EXPECT_EQ(after.lines(), before.lines());
    EXPECT_NE(after.bytes, before.bytes);
  }
  // After a reset and after a flush.
  EXPECT_GT(resets, 0);
  EXPECT_GT(alike, resets);
}

TEST(cosim, textures_lie_anywhere_unless_they_are_kept) {
  RandomBatches batches(1, 16);
  RandomBatches kept(1, 16);
  kept.keep_at_line_0();
  std::int64_t bits = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Batch batch = batches.make(i, 4000);
    EXPECT_TRUE(batch.memory->has_line(batch.memory->first_line));
    EXPECT_FALSE(batch.memory->has_line(batch.memory->first_line - 1));
    const auto end = batch.memory->first_line + static_cast<std::int64_t>(batch.memory->lines());
    EXPECT_FALSE(batch.memory->has_line(end));
    EXPECT_LE(end, Formats<kUnit>::kLine.max_raw() + 1);
    bits |= batch.memory->first_line;
    const Batch same = kept.make(i, 4000);
    EXPECT_EQ(same.memory->level_base[0], 0);
    EXPECT_EQ(same.memory->bytes, batch.memory->bytes);
    EXPECT_TRUE(std::ranges::equal(same.memory->line(0), batch.memory->line(batch.memory->first_line)));
  }
  EXPECT_EQ(bits, Formats<kUnit>::kLine.max_raw());
}

TEST(cosim, two_batches_share_a_texture_and_follow_at_once) {
  RandomBatches batches(5, 16);
  const Batch first = batches.make(0, 1000);
  const auto lines = first.memory->lines();
  EXPECT_TRUE(first.same_texture_follows);
  const Batch second = batches.make(1, 1000);
  EXPECT_FALSE(second.same_texture_follows);
  EXPECT_EQ(second.memory->lines(), lines);
  // By itself it is the same.
  RandomBatches others(5, 16);
  const Batch again = others.make(1, 1000);
  ASSERT_EQ(again.lookups.size(), 16U);
  EXPECT_EQ(again.memory->lines(), lines);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(again.lookups[7].dsdx), std::bit_cast<std::uint32_t>(second.lookups[7].dsdx));
}

// Of the batch and the digest of those before it.
std::uint64_t digest_of(const Batch& batch, std::uint64_t before) {
  std::array<std::uint32_t, beat_words<SamplerState<kUnit>>()> sampler{};
  pack(batch.sampler, sampler);
  std::uint64_t digest = XXH3_64bits_withSeed(sampler.data(), sizeof sampler, before);
  digest = XXH3_64bits_withSeed(batch.memory->bytes.data(), batch.memory->bytes.size(), digest);
  static_assert(sizeof(Lookup) == 6 * sizeof(float));
  return XXH3_64bits_withSeed(batch.lookups.data(), batch.lookups.size_bytes(), digest);
}

// Compilers evaluate the operands of a sum or the arguments of a call in an order of their own: what draws two random
// numbers there differs between them. Recorded anew when the batches are to change.
TEST(cosim, a_seed_gives_the_same_batches_with_every_compiler) {
  std::uint64_t random = 0;
  RandomBatches random_batches(1, 64);
  for (std::uint64_t i = 0; i < 64; ++i) random = digest_of(random_batches.make(i, 64 * 64), random);
  EXPECT_EQ(random, 6669357138149267361U);
  std::uint64_t close = 0;
  const CloseBatches close_batches(1, 8);
  for (std::size_t i = 0; i < close_batches.size(); ++i) close = digest_of(close_batches[i], close);
  EXPECT_EQ(close, 14150870871684838617U);
}

// Beats leave every stage in the cycles that they left it in when this was recorded: a change of the RTL that moves one
// shows here, and is recorded anew when it is meant.
TEST(cosim, every_stage_keeps_its_pace) {
  const Case subject = scene_case(find_scene("window"), 24, 16);
  SamplerOptions options;
  options.mode = Mode::kTable;
  Cosimulation simulation(make_fast_unit, {3, 0.2, 1});
  ASSERT_TRUE(simulation.run(
      {make_sampler<kUnit>(options, subject.texture, subject.memory), &subject.memory, subject.lookups}));
  EXPECT_EQ(simulation.pace(), 5166961719130313318U) << simulation.cycles();
}

TEST(cosim, timing_changes_no_pixel) {
  const Case subject = scene_case(find_scene("window"), 24, 16);
  const CosimResult quick = run_case(subject, {}, {1, 0, 1});
  const CosimResult slow = run_case(subject, {}, {200, 0.5, 99});
  ASSERT_EQ(quick.pixels.size(), slow.pixels.size());
  for (std::size_t i = 0; i < quick.pixels.size(); ++i) EXPECT_EQ(quick.pixels[i].colour, slow.pixels[i].colour);
  EXPECT_GT(slow.cycles, 2 * quick.cycles);
  EXPECT_EQ(quick.cycles, run_case(subject, {}, {1, 0, 1}).cycles) << "the same run twice takes the same cycles";
  EXPECT_EQ(quick.cycles, run_case(subject, {}, {0, 0, 1}).cycles) << "no response is taken in its request's cycle";
}

TEST(cosim, one_probe_a_cycle_when_lines_hit) {
  // Everything within two levels of a 16 x 16 texture, one in each half of the cache: each line misses once.
  Case subject = noise_case(16, 16, TexelFormat::kRgba8, false, 3);
  while (subject.lookups.size() < 20000) subject.lookups.push_back(subject.lookups[subject.lookups.size() % 400]);
  for (auto& lookup : subject.lookups) lookup.s = std::abs(lookup.s) / 8 + 0.25F;
  for (auto& lookup : subject.lookups) lookup.t = std::abs(lookup.t) / 8 + 0.25F;
  SamplerOptions options;
  options.max_level = 1;
  const CosimResult result = run_case(subject, options, {1, 0, 1});
  constexpr std::uint64_t kFillAndMisses = 400;
  EXPECT_LE(result.cycles, result.probes + kFillAndMisses);
}

TEST(cosim, replay_is_the_lookup_alone) {
  const Case subject = scene_case(find_scene("bricks"), 16, 16);
  const CosimResult result =
      run_job(subject.job({}, {1, 0, 1}), make_fast_unit, {}, ReplayRange{37, 39}, true, nullptr);
  EXPECT_EQ(result.mismatches, 0U);
  ASSERT_EQ(result.pixels.size(), 3U);
  const CosimResult all = run_case(subject, {});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(result.pixels[i].colour, all.pixels[37 + i].colour);
}

}  // namespace
}  // namespace feline
