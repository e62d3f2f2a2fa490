// SPDX-License-Identifier: Apache-2.0
// Every shortcut, alone and together, changes no bit of any plan and pixel; what each counts is known by hand.
#include "model/shortcuts.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "model/make_sampler.h"
#include "tables/pack.h"
#include "tests/support/describe.h"
#include "tests/support/lookups.h"
#include "tests/support/pruned_configs.h"
#include "tests/support/samplers.h"

namespace feline {
namespace {

// None, each alone, all but each, all.
std::vector<Shortcuts> choices() {
  std::vector<Shortcuts> all{kNoShortcuts, Shortcuts{}};
  for (const ShortcutName& shortcut : kShortcutNames) {
    all.push_back(kNoShortcuts);
    all.back().*shortcut.is_on = true;
    all.emplace_back();
    all.back().*shortcut.is_on = false;
  }
  return all;
}

std::string name_of(const Shortcuts& shortcuts) {
  std::string names;
  for (const ShortcutName& shortcut : kShortcutNames) {
    if (shortcuts.*shortcut.is_on) names += std::string(shortcut.name) + " ";
  }
  return names.empty() ? "no shortcut" : names;
}

TEST(shortcuts, defaults) {
  const Shortcuts all;
  const ShortcutCounts nothing;
  EXPECT_EQ(kShortcutNames.size(), 6U);
  for (const ShortcutName& shortcut : kShortcutNames) {
    EXPECT_TRUE(all.*shortcut.is_on) << shortcut.name;
    EXPECT_FALSE(kNoShortcuts.*shortcut.is_on) << shortcut.name;
    EXPECT_EQ(nothing.*shortcut.saved, 0) << shortcut.name;
  }
  EXPECT_EQ(nothing.lookups, 0);
  EXPECT_EQ(nothing.probes, 0);
}

// One lookup's plan and pixel, stage by stage and by a unit with shortcuts.
template <Config kConfig, LineSource Lines>
void expect_same(const Lookup& lookup, const SamplerState<kConfig>& state, const TextureMemory& memory,
                 ShortcutUnit<kConfig, Lines>& unit) {
  const auto request = make_request<kConfig>(lookup, 1234);
  std::optional<PlanBeat<kConfig>> plan, shortcut_plan;
  const auto pixel = sample<kConfig>(request, state, memory, [&]<typename Beat>(const Beat& beat) {
    if constexpr (std::is_same_v<Beat, PlanBeat<kConfig>>) plan = beat;
  });
  const auto shortcut_pixel = unit.sample(request, [&](const PlanBeat<kConfig>& beat) { shortcut_plan = beat; });
  ASSERT_TRUE(same(pixel, shortcut_pixel));
  ASSERT_TRUE(same(*plan, *shortcut_plan));
}

// Nothing for a texture that the configuration's unit cannot hold.
template <Config kConfig>
std::optional<SamplerState<kConfig>> state_of(const SamplerOptions& options, const TestScene& scene) {
  try {
    return make_sampler<kConfig>(options, scene.texture, scene.memory);
  } catch (const SamplerError&) {
    return std::nullopt;
  }
}

template <Config kConfig>
void expect_same_for_random(std::string_view name, int samplers) {
  SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for(name);
  const std::vector<Shortcuts> all = choices();
  int states = 0;
  for (const Content content : {Content::kNoise, Content::kExtremes}) {
    for (const TestScene& scene : make_scenes(random, content)) {
      for (int i = 0; i < samplers; ++i) {
        const SamplerOptions options = random_options(random);
        const auto state = state_of<kConfig>(options, scene);
        if (!state) continue;
        ++states;
        for (const Shortcuts& shortcuts : all) {
          ShortcutUnit<kConfig, const TextureMemory> unit(*state, scene.memory, shortcuts);
          for (int lookups = 0; lookups < 5; ++lookups) {
            const MipLevel& base = scene.texture.levels.front();
            const Lookup lookup = any_lookup(random, base.width, base.height);
            expect_same<kConfig>(lookup, *state, scene.memory, unit);
            if (testing::Test::HasFatalFailure()) {
              FAIL() << name_of(shortcuts) << one_line(lookup) << " " << one_line(*state);
            }
          }
        }
      }
    }
  }
  EXPECT_GE(states, samplers);
}

TEST(shortcuts, change_no_bit) { expect_same_for_random<kDefaultConfig>("shortcuts.default", 40); }

TEST(shortcuts, change_no_bit_in_the_widest_formats) {
  constexpr Config kWidest = [] {
    Config config;
    config.subtexel_bits = config.weight_bits = 10;
    config.channel_fraction_bits = 6;
    config.max_probes = 32;
    return config;
  }();
  expect_same_for_random<kWidest>("shortcuts.widest", 10);
}

TEST(shortcuts, change_no_bit_without_features) {
  constexpr Config kPlain = [] {
    Config config;
    Features& f = config.features;
    f.ext = f.simple_feline = f.table_feline = f.gaussian = f.srgb = f.mirrored_repeat = f.clamp_to_border = false;
    return config;
  }();
  expect_same_for_random<kPlain>("shortcuts.plain", 10);
}

// A border's alpha is looked at as a texel's is.
TEST(shortcuts, change_no_bit_without_alpha) {
  constexpr Config kOpaqueUnit = [] {
    Config config;
    config.features.alpha = false;
    return config;
  }();
  expect_same_for_random<kOpaqueUnit>("shortcuts.opaque_unit", 10);
}

// Cells, weights and alpha that are missing, and textures that are refused.
TEST(shortcuts, change_no_bit_in_pruned_units) {
  expect_same_for_random<kSimpleUnit>("shortcuts.simple", 10);
  expect_same_for_random<kHoledTableUnit>("shortcuts.holed", 10);
  expect_same_for_random<kPlainUnit>("shortcuts.plain_unit", 10);
  expect_same_for_random<kExtUnit>("shortcuts.ext", 10);
}

// A plain level of detail and a texel's centre, an 8 x 8 texture, one texel a pixel unless said.
struct Known {
  std::string name;
  TexelFormat format = TexelFormat::kRgba8;
  SamplerOptions options = plain_options(Mode::kSimple);
  Lookup lookup{2.5F / 8, 4.5F / 8, 1.0F / 8, 0, 0, 1.0F / 8};
  ShortcutCounts counts{};
};

// Of an RGBA8 texture whose alphas are all 255, three channels are filtered; one that is not, and none is left out.
TEST(shortcuts, opaque_textures) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("shortcuts.opaque");
  TestScene scene = make_scene(random, 16, 16, TexelFormat::kRgba8, false, Content::kNoise);
  EXPECT_FALSE(scene.memory.opaque());
  for (MipLevel& level : scene.texture.levels) {
    for (std::size_t i = 3; i < level.texels.size(); i += 4) level.texels[i] = 255;
  }
  scene.memory = layout_texture(scene.texture);
  EXPECT_TRUE(scene.memory.opaque());
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kClampToBorder}) {
    SamplerOptions options = plain_options(Mode::kSimple);
    options.wrap_s = options.wrap_t = wrap;
    const State state = make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
    ShortcutUnit<kDefaultConfig, const TextureMemory> unit(state, scene.memory);
    for (int i = 0; i < 1000; ++i) {
      expect_same<kDefaultConfig>(any_lookup(random, 16, 16), state, scene.memory, unit);
    }
    // The border is transparent black.
    EXPECT_EQ(unit.counts().absent_channels > 0, wrap == Wrap::kRepeat);
  }
  scene.texture.levels.back().texels[3] = 254;
  EXPECT_FALSE(layout_texture(scene.texture).opaque());
}

TEST(shortcuts, count_what_they_leave_out) {
  const auto counts = [](std::int64_t probes, std::int64_t levels, std::int64_t points, std::int64_t texels,
                         std::int64_t channels, std::int64_t decodings) {
    return ShortcutCounts{1, probes, levels, 0, points, texels, channels, decodings};
  };
  std::vector<Known> cases(1, {"a texel's centre at level 0"});
  cases.back().counts = counts(1, 1, 1, 3, 0, 1);
  cases.push_back({"between two columns"});
  cases.back().lookup.s = 2.75F / 8;
  cases.back().counts = counts(1, 1, 1, 2, 0, 2);
  cases.push_back({"between two rows"});
  cases.back().lookup.t = 4.25F / 8;
  cases.back().counts = counts(1, 1, 1, 2, 0, 2);
  cases.push_back({"between four texels"});
  cases.back().lookup.s = cases.back().lookup.t = 2.75F / 8;
  cases.back().counts = counts(1, 1, 1, 0, 0, 4);
  cases.push_back({"one channel"});
  cases.back().format = TexelFormat::kR8;
  cases.back().counts = counts(1, 1, 1, 3, 3, 1);
  cases.push_back({"two channels, two levels: the coarse one is between four texels"});
  cases.back().format = TexelFormat::kRg8;
  cases.back().options.level_bias = 0.5;
  cases.back().counts = counts(1, 0, 1, 3, 4, 5);
  cases.push_back({"nearest: one texel wherever it lies"});
  cases.back().options.mode = Mode::kNearest;
  cases.back().options.magnify = Magnify::kNearest;
  cases.back().lookup.s = 2.9F / 8;
  cases.back().counts = counts(1, 1, 1, 3, 0, 1);
  cases.push_back({"a border: no texel is decoded"});
  cases.back().options.wrap_s = cases.back().options.wrap_t = Wrap::kClampToBorder;
  cases.back().lookup.s = cases.back().lookup.t = -5.5F / 8;
  cases.back().counts = counts(1, 1, 1, 3, 0, 0);
  // 2 major/minor - 1 probes, at level 0 as the minor radius is one texel, centres a texel apart.
  cases.push_back({"three probes in a row of texels"});
  cases.back().lookup.dsdx = 2.0F / 8;
  cases.back().counts = counts(3, 3, 0, 9, 0, 3);
  for (const Known& known : cases) {
    SCOPED_TRACE(known.name);
    Random random(5);
    const TestScene scene = make_scene(random, 8, 8, known.format, false, Content::kNoise);
    const State state = make_sampler<kDefaultConfig>(known.options, scene.texture, scene.memory);
    ShortcutUnit<kDefaultConfig, const TextureMemory> unit(state, scene.memory);
    expect_same<kDefaultConfig>(known.lookup, state, scene.memory, unit);
    EXPECT_EQ(unit.counts().lookups, 1);
    EXPECT_EQ(unit.counts().probes, known.counts.probes);
    for (const ShortcutName& shortcut : kShortcutNames) {
      EXPECT_EQ(unit.counts().*shortcut.saved, known.counts.*shortcut.saved) << shortcut.name;
    }
    ShortcutUnit<kDefaultConfig, const TextureMemory> none(state, scene.memory, kNoShortcuts);
    expect_same<kDefaultConfig>(known.lookup, state, scene.memory, none);
    for (const ShortcutName& shortcut : kShortcutNames) EXPECT_EQ(none.counts().*shortcut.saved, 0) << shortcut.name;
  }
}

// Weights are rounded so that none vanishes, in any legal configuration: the shortcut is for tables of one's own.
TEST(shortcuts, no_weight_table_has_a_probe_of_weight_0) {
  for (int bits = 6; bits <= 10; ++bits) {
    for (int most = 2; most <= 32; ++most) {
      Config config;
      config.weight_bits = bits;
      config.max_probes = most;
      const Rom rom = weight_rom(config);
      const auto columns = static_cast<std::size_t>(most / 2 + 1);
      for (int probes = 2; probes <= most; ++probes) {
        for (int row = 4 * probes - 7; row <= 4 * probes - 4; ++row) {
          for (int n = 1 - probes; n < probes; n += 2) {
            const auto column = static_cast<std::size_t>((std::abs(n) + 1) / 2);
            ASSERT_NE(rom.words[static_cast<std::size_t>(row) * columns + column], 0u)
                << bits << " bits, at most " << most << " probes, row " << row << ", column " << column;
          }
        }
      }
    }
  }
}

TEST(shortcuts, probes_of_weight_0_are_left_out) {
  // A configuration of its own, for its table is spoilt: of three probes the outer ones weigh nothing.
  constexpr Config kOwn = [] {
    Config config;
    config.tag_bits = 15;
    return config;
  }();
  for (std::size_t row = 5; row <= 8; ++row) {
    constexpr auto kColumns = static_cast<std::size_t>(Formats<kOwn>::kWeightColumns);
    auto& words = const_cast<std::vector<std::uint64_t>&>(roms<kOwn>().weight.words);
    words[row * kColumns] = 256;
    words[row * kColumns + 1] = 0;
  }
  Random random(6);
  const TestScene scene = make_scene(random, 8, 8, TexelFormat::kRgba8, false, Content::kNoise);
  const auto state = make_sampler<kOwn>(plain_options(Mode::kSimple), scene.texture, scene.memory);
  ShortcutUnit<kOwn, const TextureMemory> unit(state, scene.memory);
  expect_same<kOwn>({2.5F / 8, 4.5F / 8, 2.0F / 8, 0, 0, 1.0F / 8}, state, scene.memory, unit);
  EXPECT_EQ(unit.counts().probes, 3);
  EXPECT_EQ(unit.counts().weightless_probes, 2);
  EXPECT_EQ(unit.counts().decoded_codes, 1);
}

// A border has the texels' channels: what both lack is not filtered. A driver of one's own may give it another one:
// all are filtered then.
TEST(shortcuts, border_with_other_channels_than_the_texels) {
  Random random(7);
  for (const auto& [format, stored] : {std::pair{TexelFormat::kR8, 1U}, {TexelFormat::kRg8, 2U}}) {
    const TestScene scene = make_scene(random, 8, 8, format, false, Content::kNoise);
    SamplerOptions options = plain_options(Mode::kTable);
    options.wrap_s = Wrap::kClampToBorder;
    options.border = {0.5, 0.5, 0.5, 0.5};
    const State plain = make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
    for (unsigned channel = stored - 1; channel < 4; ++channel) {
      State state = plain;
      state.border[channel] = state.border[channel].from_raw(77 * 16);
      ShortcutUnit<kDefaultConfig, const TextureMemory> unit(state, scene.memory);
      for (int i = 0; i < 1000; ++i) {
        expect_same<kDefaultConfig>(tame_lookup(random, 8, 8), state, scene.memory, unit);
      }
      EXPECT_EQ(unit.counts().absent_channels > 0, channel < stored) << stored << " channels, border's " << channel;
    }
  }
}

// A sum that one more in its last place would round the other way: one lookup in some hundred million is such, this one
// was sought out.
TEST(shortcuts, sum_just_below_a_tie) {
  Random random(1);
  const TestScene scene = make_scene(random, 8, 8, TexelFormat::kRgba8, true, Content::kNoise);
  SamplerOptions options = plain_options(Mode::kSimple);
  options.level_bias = 129.0 / 256;
  const State state = make_sampler<kDefaultConfig>(options, scene.texture, scene.memory);
  const Lookup lookup{0.679721415F, 0.421204627F, 0.460666388F, 0, 0, 1.0F / 8};
  std::int64_t sum = 0;
  const auto request = make_request<kDefaultConfig>(lookup, 1234);
  sample<kDefaultConfig>(request, state, scene.memory, [&]<typename Beat>(const Beat& beat) {
    if constexpr (std::is_same_v<Beat, FilterBeat<kDefaultConfig>>) sum += beat.weight.raw() * beat.colour[1].raw();
  });
  using F = Formats<kDefaultConfig>;
  constexpr std::int64_t kUnit = std::int64_t{1} << (F::kAccumulated.fraction_bits - F::kPixel.fraction_bits);
  ASSERT_EQ(sum % kUnit, kUnit / 2 - 1);
  ShortcutUnit<kDefaultConfig, const TextureMemory> unit(state, scene.memory);
  expect_same<kDefaultConfig>(lookup, state, scene.memory, unit);
}

// Memory that tells which lines were asked for.
struct WatchedMemory {
  const TextureMemory& memory;
  std::set<std::int64_t> asked{};
  std::span<const std::uint8_t> line(std::int64_t index) {
    asked.insert(index);
    return memory.line(index);
  }
  bool opaque() const { return memory.opaque(); }
};

TEST(shortcuts, lines_of_no_weight_are_not_asked_for) {
  Random random(8);
  const TestScene scene = make_scene(random, 8, 8, TexelFormat::kRgba8, false, Content::kNoise);
  const State state = make_sampler<kDefaultConfig>(plain_options(Mode::kSimple), scene.texture, scene.memory);
  WatchedMemory watched{scene.memory};
  ShortcutUnit<kDefaultConfig, WatchedMemory> unit(state, watched);
  // The last texel before the next line, at its centre and beyond it.
  const Lookup centre{3.5F / 8, 3.5F / 8, 1.0F / 8, 0, 0, 1.0F / 8};
  expect_same<kDefaultConfig>(centre, state, scene.memory, unit);
  EXPECT_EQ(watched.asked, (std::set<std::int64_t>{0}));
  Lookup beyond = centre;
  beyond.s = 3.75F / 8;
  expect_same<kDefaultConfig>(beyond, state, scene.memory, unit);
  EXPECT_EQ(watched.asked, (std::set<std::int64_t>{0, 1}));
}

}  // namespace
}  // namespace feline
