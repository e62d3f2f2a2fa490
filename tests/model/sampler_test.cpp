// SPDX-License-Identifier: Apache-2.0
// The driver's code: the sampler state, what it refuses, and the layout of memory.
#include "model/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

#include "model/make_sampler.h"
#include "tests/support/describe.h"
#include "tests/support/oracle.h"
#include "tests/support/pruned_configs.h"
#include "tests/support/samplers.h"

namespace feline {
namespace {

// 100,000 random options on textures of every shape and format.
TEST(sampler, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_sampler.equals_exact_arithmetic");
  const auto scenes = make_scenes(random, Content::kNoise);
  for (int i = 0; i < 100000; ++i) {
    const TestScene& scene = scenes[static_cast<std::size_t>(random.below(static_cast<std::int64_t>(scenes.size())))];
    const SamplerOptions options = random_options(random);
    const Texture& texture = scene.texture;
    const State got = make_sampler<kDefaultConfig>(options, texture, scene.memory);
    const State want =
        oracle::sampler_state(options, texture.format, texture.srgb, texture.levels[0].width, texture.levels[0].height,
                              static_cast<int>(texture.levels.size()), scene.memory.level_base);
    ASSERT_TRUE(same(got, want)) << mismatch(got, want);
  }
}

// Every size: reciprocal * 2^-15 * 2^-shift is 1/size to half a unit, and normalized.
TEST(sampler, reciprocal_of_every_size) {
  for (int size = 1; size <= 16384; ++size) {
    const Texture texture{
        TexelFormat::kR8, false, {{size, 1, std::vector<std::uint8_t>(static_cast<std::size_t>(size))}}};
    const State state = make_sampler<kDefaultConfig>(SamplerOptions{}, texture, TextureMemory{{}, {0}});
    const auto mantissa = state.width_reciprocal.raw();
    ASSERT_GE(mantissa, 32768) << size;
    ASSERT_LE(mantissa, 65535) << size;
    const std::int64_t whole = std::int64_t{1} << (15 + state.width_shift.raw());
    ASSERT_LE(2 * std::abs(mantissa * size - whole), size) << size;
  }
}

TEST(sampler, named_parameter_sets_are_the_papers) {
  EXPECT_EQ(kHighQuality.length_factor, 0.9625);
  EXPECT_EQ(kHighQuality.blur_factor, 1.15625);
  EXPECT_EQ(kHighQuality.alias_factor, 1.1532);
  EXPECT_EQ(kHighEfficiency.length_factor, 0.9625);
  EXPECT_EQ(kHighEfficiency.blur_factor, 1.3125);
  EXPECT_EQ(kHighEfficiency.alias_factor, 1.3544);
  EXPECT_EQ(kExact.rounding, ProbeRounding::kNearest);
  EXPECT_EQ(kHighQuality.rounding, ProbeRounding::kCeiling);
  EXPECT_EQ(kHighEfficiency.rounding, ProbeRounding::kCeiling);
}

// What nobody chose: the exact probes of the table, linear and repeated, all levels, a border of nothing.
TEST(sampler, defaults) {
  const SamplerOptions options;
  EXPECT_EQ(options.mode, Mode::kTable);
  EXPECT_EQ(options.kernel, Kernel::kBilinear);
  EXPECT_EQ(options.magnify, Magnify::kLinear);
  EXPECT_EQ(options.wrap_s, Wrap::kRepeat);
  EXPECT_EQ(options.wrap_t, Wrap::kRepeat);
  EXPECT_EQ(options.max_probes, 16);
  EXPECT_EQ(options.level_bias, 0);
  EXPECT_EQ(options.min_level, 0);
  EXPECT_EQ(options.max_level, 16 - 1.0 / 256);
  EXPECT_EQ(options.border, (std::array<double, 4>{0, 0, 0, 0}));
  const ProbeParameters own;
  for (const ProbeParameters& probes : {own, options.probes, kExact}) {
    EXPECT_EQ(probes.rounding, ProbeRounding::kNearest);
    EXPECT_EQ(probes.length_factor, 1);
    EXPECT_EQ(probes.blur_factor, 1);
    EXPECT_EQ(probes.alias_factor, 1);
  }
}

// What has no texels yet.
TEST(sampler, defaults_of_textures) {
  const TextureShape shape;
  EXPECT_EQ(shape.format, TexelFormat::kRgba8);
  EXPECT_FALSE(shape.srgb);
  EXPECT_EQ(std::tuple(shape.width, shape.height, shape.levels), std::tuple(0, 0, 0));
  const Texture texture;
  EXPECT_EQ(texture.format, TexelFormat::kRgba8);
  EXPECT_FALSE(texture.srgb);
  const MipLevel level;
  EXPECT_EQ(std::tuple(level.width, level.height), std::tuple(0, 0));
}

struct Refusal {
  const char* field;
  std::function<void(SamplerOptions&, Texture&)> spoil;
};

TEST(sampler, refuses_what_the_machine_cannot_hold) {
  const double nan = std::nan("");
  const std::vector<Refusal> refusals{{"length_factor", [](auto& o, auto&) { o.probes.length_factor = 0; }},
                                      {"length_factor", [](auto& o, auto&) { o.probes.length_factor = 1.01; }},
                                      {"blur_factor", [](auto& o, auto&) { o.probes.blur_factor = 0.99; }},
                                      {"blur_factor", [](auto& o, auto&) { o.probes.blur_factor = 2; }},
                                      {"alias_factor", [nan](auto& o, auto&) { o.probes.alias_factor = nan; }},
                                      {"alias_factor", [](auto& o, auto&) { o.probes.alias_factor = 2.1; }},
                                      {"alias_factor", [](auto& o, auto&) { o.probes.alias_factor = 0.99; }},
                                      {"max_probes", [](auto& o, auto&) { o.max_probes = 0; }},
                                      {"max_probes", [](auto& o, auto&) { o.max_probes = 17; }},
                                      {"level_bias", [](auto& o, auto&) { o.level_bias = 16; }},
                                      {"level_bias", [](auto& o, auto&) { o.level_bias = 16 - 1.0 / 512; }},
                                      {"level_bias", [](auto& o, auto&) { o.level_bias = -16.01; }},
                                      {"max_level", [](auto& o, auto&) { o.max_level = -1; }},
                                      {"min_level", [](auto& o, auto&) { o.min_level = 2, o.max_level = 1; }},
                                      {"min_level", [](auto& o, auto&) { o.min_level = -0.01; }},
                                      {"border", [](auto& o, auto&) { o.border[2] = 1.5; }},
                                      {"border", [](auto& o, auto&) { o.border[0] = -0.01; }},
                                      {"levels", [](auto&, auto& t) { t.levels.clear(); }},
                                      {"levels", [](auto&, auto& t) { t.levels.push_back(t.levels.back()); }},
                                      {"level 0", [](auto&, auto& t) { t.levels[0].texels.pop_back(); }},
                                      {"level 1", [](auto&, auto& t) { t.levels[1].width = 3; }},
                                      {"level 1", [](auto&, auto& t) { t.levels[1].height = 3; }},
                                      {"level 2", [](auto&, auto& t) { t.levels[2].texels.pop_back(); }},
                                      {"size", [](auto&, auto& t) { t.levels[0].width = 0; }},
                                      {"size", [](auto&, auto& t) { t.levels[0].height = 0; }},
                                      {"size", [](auto&, auto& t) { t.levels[0].height = 16385; }}};
  for (const Refusal& refusal : refusals) {
    Random random(1);
    TestScene scene = make_scene(random, 4, 4, TexelFormat::kR8, false, Content::kNoise);
    SamplerOptions options;
    refusal.spoil(options, scene.texture);
    try {
      make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
      ADD_FAILURE() << refusal.field << " was not refused";
    } catch (const SamplerError& error) {
      EXPECT_EQ(error.field, refusal.field);
      EXPECT_FALSE(error.value.empty());
      EXPECT_FALSE(error.legal.empty());
      EXPECT_NE(std::string(error.what()).find(error.field), std::string::npos);
    }
  }
}

template <Config kConfig>
std::string refusal_of(int width, int height, int levels) {
  try {
    make_sampler<kConfig>({}, TextureShape{TexelFormat::kR8, false, width, height, levels, {}});
  } catch (const SamplerError& error) {
    return error.field + ": " + error.legal;
  }
  return "none";
}

// A texture that nobody has loaded is refused by its shape.
TEST(sampler, refuses_shapes) {
  EXPECT_EQ(refusal_of<kDefaultConfig>(4, 4, 0), "levels: at least 1");
  EXPECT_EQ(refusal_of<kDefaultConfig>(4, 7, 4), "levels: at most 3");
  EXPECT_EQ(refusal_of<kDefaultConfig>(4, 7, 3), "none");
  EXPECT_EQ(refusal_of<kDefaultConfig>(16385, 1, 1), "size: 1 x 1 to 16384 x 16384");
  EXPECT_EQ(refusal_of<kDefaultConfig>(1, 16385, 1), "size: 1 x 1 to 16384 x 16384");
  EXPECT_EQ(refusal_of<kDefaultConfig>(16384, 16384, 15), "none");
  EXPECT_EQ(refusal_of<kHoledTableUnit>(3, 4, 1), "size: powers of two");
  EXPECT_EQ(refusal_of<kHoledTableUnit>(4, 3, 1), "size: powers of two");
  EXPECT_EQ(refusal_of<kHoledTableUnit>(4, 8, 1), "none");
}

TEST(sampler, levels_lie_where_the_shape_says) {
  const State state = make_sampler<kDefaultConfig>({}, TextureShape{TexelFormat::kR8, false, 4, 4, 3, {7, 5, 9}});
  for (const auto& [level, line] : {std::pair{0U, 7}, {1U, 5}, {2U, 9}, {3U, 0}}) {
    EXPECT_EQ(state.level_base[level].raw(), line);
  }
}

// OpenGL 4.6, 8.14.2: a border has the channels that the texture has.
TEST(sampler, border_has_the_channels_of_the_format) {
  Random random(3);
  SamplerOptions options;
  options.border = {0.2, 0.4, 0.6, 0.8};
  const auto border_of = [&](TexelFormat format) {
    const TestScene scene = make_scene(random, 4, 4, format, false, Content::kNoise);
    const State state = make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
    std::array<double, 4> border{};
    for (std::size_t c = 0; c < 4; ++c) border[c] = state.border[c].value() / 255;
    return border;
  };
  EXPECT_EQ(border_of(TexelFormat::kR8), (std::array{0.2, 0.0, 0.0, 1.0}));
  EXPECT_EQ(border_of(TexelFormat::kRg8), (std::array{0.2, 0.4, 0.0, 1.0}));
  EXPECT_EQ(border_of(TexelFormat::kRgba8), (std::array{0.2, 0.4, 0.6, 0.8}));
}

TEST(memory, opaque_is_what_has_an_alpha_that_is_one_everywhere) {
  EXPECT_FALSE(TextureMemory{}.is_opaque);
  EXPECT_EQ(TextureMemory{}.first_line, 0);
  Random random(4);
  for (const auto format : {TexelFormat::kR8, TexelFormat::kRg8, TexelFormat::kRgba8}) {
    TestScene scene = make_scene(random, 5, 3, format, false, Content::kNoise);
    EXPECT_FALSE(scene.memory.is_opaque);
    for (MipLevel& level : scene.texture.levels) std::ranges::fill(level.texels, std::uint8_t{255});
    EXPECT_EQ(layout_texture(scene.texture).is_opaque, format == TexelFormat::kRgba8);
    scene.texture.levels[1].texels.back() = 254;
    EXPECT_FALSE(layout_texture(scene.texture).is_opaque);
  }
}

TEST(memory, a_texture_may_lie_anywhere) {
  constexpr std::int64_t kFirst = 12345;
  Random random(3);
  for (const auto& scene : make_scenes(random, Content::kNoise)) {
    const TextureMemory moved = layout_texture(scene.texture, kFirst);
    const auto lines = static_cast<std::int64_t>(scene.memory.lines());
    ASSERT_EQ(moved.bytes, scene.memory.bytes);
    for (std::size_t k = 0; k < scene.memory.level_base.size(); ++k) {
      ASSERT_EQ(moved.level_base[k], scene.memory.level_base[k] + kFirst);
    }
    for (const std::int64_t line : {std::int64_t{0}, lines - 1}) {
      ASSERT_TRUE(moved.has_line(kFirst + line));
      ASSERT_TRUE(std::ranges::equal(moved.line(kFirst + line), scene.memory.line(line)));
    }
    ASSERT_FALSE(moved.has_line(kFirst - 1));
    ASSERT_FALSE(moved.has_line(kFirst + lines));
  }
}

// Tiles of 4 x 4, rows of tiles, levels one after the other: each texel once, and nothing else but zeros.
TEST(memory, layout_holds_every_texel_once) {
  Random random(2);
  for (const auto& scene : make_scenes(random, Content::kNoise)) {
    const auto channels = static_cast<std::size_t>(bytes_per_texel(scene.texture.format));
    std::vector<std::uint8_t> expected(scene.memory.bytes.size(), 0);
    std::size_t line = 0;
    for (std::size_t k = 0; k < scene.texture.levels.size(); ++k) {
      const MipLevel& level = scene.texture.levels[k];
      ASSERT_EQ(scene.memory.level_base[k], static_cast<std::int64_t>(line));
      for (int tile_y = 0; tile_y < level.height; tile_y += 4) {
        for (int tile_x = 0; tile_x < level.width; tile_x += 4, ++line) {
          for (int y = tile_y; y < std::min(tile_y + 4, level.height); ++y) {
            for (int x = tile_x; x < std::min(tile_x + 4, level.width); ++x) {
              for (std::size_t c = 0; c < channels; ++c) {
                const auto within = static_cast<std::size_t>(4 * (y - tile_y) + (x - tile_x)) * channels + c;
                const auto from = static_cast<std::size_t>(y * level.width + x) * channels + c;
                expected[line * 64 + within] = level.texels[from];
              }
            }
          }
        }
      }
    }
    ASSERT_EQ(scene.memory.lines(), line);
    ASSERT_EQ(scene.memory.bytes, expected);
  }
}

}  // namespace
}  // namespace feline
