// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tables/emit.h"
#include "tables/stages.h"
#include "tests/support/pruned_configs.h"

namespace feline {
namespace {

const std::filesystem::path kDirectory = std::filesystem::path(FELINE_SOURCE_DIR) / "tables" / "generated";

// What is checked in is what the generator writes, byte for byte, and nothing else lies there.
TEST(generated, files_equal_a_fresh_run) {
  std::set<std::string> names;
  for (const auto& file : generate(kDefaultConfig, measured_roms(kDefaultConfig))) {
    names.insert(file.name);
    std::ifstream in(kDirectory / file.name, std::ios::binary);
    std::stringstream held;
    held << in.rdbuf();
    EXPECT_TRUE(in.good() && held.str() == file.text)
        << "tables/generated/" << file.name << " is stale; run: ./testbench/generate";
  }
  for (const auto& entry : std::filesystem::directory_iterator(kDirectory)) {
    EXPECT_TRUE(names.contains(entry.path().filename().string()))
        << "tables/generated/" << entry.path().filename().string() << " is made by nobody";
  }
}

template <Config kConfig>
std::uint64_t print_of() {
  return fingerprint(kConfig, package_parts(kConfig), roms<kDefaultConfig>());
}

// Calls change(config) on the default and takes the fingerprint, the ROMs left alone.
#define EXPECT_CHANGES(change)                                        \
  {                                                                   \
    constexpr Config kOther = [] {                                    \
      Config config;                                                  \
      config.change;                                                  \
      return config;                                                  \
    }();                                                              \
    EXPECT_TRUE(prints.insert(print_of<kOther>()).second) << #change; \
  }

TEST(generated, fingerprint_changes_with_every_field_of_the_configuration) {
  std::set<std::uint64_t> prints{fingerprint<kDefaultConfig>()};
  EXPECT_FALSE(prints.insert(print_of<kDefaultConfig>()).second);
  EXPECT_CHANGES(mantissa_bits = 9)
  EXPECT_CHANGES(table_rows = 32)
  EXPECT_CHANGES(table_columns = 32)
  EXPECT_CHANGES(entry_bits = 9)
  EXPECT_CHANGES(subtexel_bits = 7)
  EXPECT_CHANGES(level_fraction_bits = 7)
  EXPECT_CHANGES(weight_bits = 9)
  EXPECT_CHANGES(factor_bits = 9)
  EXPECT_CHANGES(reciprocal_bits = 17)
  EXPECT_CHANGES(line_bits = 13)
  EXPECT_CHANGES(size_reciprocal_bits = 16)
  EXPECT_CHANGES(guard_bits = 3)
  EXPECT_CHANGES(channel_fraction_bits = 5)
  EXPECT_CHANGES(pixel_fraction_bits = 9)
  EXPECT_CHANGES(max_probes = 8)
  EXPECT_CHANGES(max_size_log2 = 13)
  EXPECT_CHANGES(tag_bits = 17)
  EXPECT_CHANGES(features.nearest = false)
  EXPECT_CHANGES(features.bilinear = false)
  EXPECT_CHANGES(features.trilinear = false)
  EXPECT_CHANGES(features.ext = false)
  EXPECT_CHANGES(features.simple_feline = false)
  EXPECT_CHANGES(features.table_feline = false)
  EXPECT_CHANGES(features.gaussian = false)
  EXPECT_CHANGES(features.factors = false)
  EXPECT_CHANGES(features.repeat = false)
  EXPECT_CHANGES(features.mirrored_repeat = false)
  EXPECT_CHANGES(features.clamp_to_edge = false)
  EXPECT_CHANGES(features.clamp_to_border = false)
  EXPECT_CHANGES(features.r8 = false)
  EXPECT_CHANGES(features.rg8 = false)
  EXPECT_CHANGES(features.rgba8 = false)
  EXPECT_CHANGES(features.srgb = false)
  EXPECT_CHANGES(features.alpha = false)
  EXPECT_CHANGES(features.any_size = false)
  EXPECT_CHANGES(features.level_blend = false)
  EXPECT_CHANGES(features.linear_texels = false)
  EXPECT_CHANGES(features.nearest_texels = false)
  EXPECT_CHANGES(features.dudx = false)
  EXPECT_CHANGES(features.dvdx = false)
  EXPECT_CHANGES(features.dudy = false)
  EXPECT_CHANGES(features.dvdy = false)
  EXPECT_CHANGES(exponent_bits = 5)
  EXPECT_CHANGES(max_levels = 9)
}

// A flipped bit of any ROM is another machine.
TEST(generated, fingerprint_changes_with_every_rom) {
  std::set<std::uint64_t> prints;
  const PackageParts parts = package_parts(kDefaultConfig);
  for (std::size_t i = 0; i < 6; ++i) {
    Roms changed = roms<kDefaultConfig>();
    Rom* const all[] = {&changed.ellipse, &changed.weight,     &changed.gaussian,
                        &changed.log2,    &changed.reciprocal, &changed.srgb};
    all[i]->words[3] ^= 1;
    EXPECT_TRUE(prints.insert(fingerprint(kDefaultConfig, parts, changed)).second) << all[i]->name;
  }
  EXPECT_FALSE(prints.contains(fingerprint<kDefaultConfig>()));
}

// The package states the fingerprint that the model computes.
TEST(generated, package_states_the_fingerprint) {
  std::ifstream in(kDirectory / "feline_pkg.sv");
  std::stringstream text;
  text << in.rdbuf();
  char want[40];
  std::snprintf(want, sizeof want, "64'h%016llx", static_cast<unsigned long long>(fingerprint<kDefaultConfig>()));
  EXPECT_NE(text.str().find(want), std::string::npos) << want;
}

// Every field of a configuration is in the lists that code goes through.
TEST(generated, lists_of_fields_are_complete) {
  std::set<std::string> names;
  for (const ConfigField& each : kConfigFields) {
    EXPECT_TRUE(names.insert(std::string(each.name)).second);
    Config config;
    EXPECT_TRUE(fault_of(config).field.empty());
    config.*each.field = each.most + 1;
    EXPECT_EQ(fault_of(config).field, each.name);
    config.*each.field = each.least - 1;
    EXPECT_EQ(fault_of(config).field, each.name);
  }
  for (const FeatureField& each : kFeatureFields) EXPECT_TRUE(names.insert(std::string(each.name)).second);
  std::ifstream in(std::filesystem::path(FELINE_SOURCE_DIR) / "tables" / "config.h");
  std::size_t declared = 0;
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, std::regex(R"(^  (?:int|bool) (\w+) = )"))) continue;
    ++declared;
    EXPECT_TRUE(names.contains(match[1])) << match[1];
  }
  EXPECT_EQ(declared, names.size());
}

template <typename Beat>
void expect_described(const PackageParts& parts) {
  const auto beat = std::ranges::find(parts.beats, Beat::kName.view(), &PackageParts::Beat::name);
  ASSERT_NE(beat, parts.beats.end());
  std::size_t i = 0;
  for_each_shape<Beat>([&](Name name, const Format& format, int count, bool is_array) {
    const PackageParts::Member& member = beat->members.at(i++);
    EXPECT_EQ(member.name, name.view());
    EXPECT_EQ(member.format, format) << beat->name << "." << member.name;
    EXPECT_EQ(member.count, count) << beat->name << "." << member.name;
    EXPECT_EQ(member.is_array, is_array);
  });
  EXPECT_EQ(i, beat->members.size());
}

template <Config kConfig>
void expect_all_described() {
  const PackageParts parts = package_parts(kConfig);
  expect_described<SamplerState<kConfig>>(parts);
  expect_described<RequestBeat<kConfig>>(parts);
  [&]<std::size_t... kStage>(std::index_sequence<kStage...>) {
    (expect_described<StageBeat<kConfig, kStage>>(parts), ...);
  }
  (std::make_index_sequence<kStageCount>{});
}

// Beats made from names when the program runs are those that the compiler makes from types.
TEST(generated, packages_of_other_configurations_have_the_beats_of_their_types) {
  expect_all_described<kDefaultConfig>();
  expect_all_described<kSimpleUnit>();
  expect_all_described<kHoledTableUnit>();
  expect_all_described<kPlainUnit>();
  expect_all_described<kExtUnit>();
}

// Words that are left out are 0, and the module says that they are not there.
TEST(generated, roms_say_what_is_left_out) {
  const Roms all = make_roms(kDefaultConfig);
  const Roms cut = make_roms(kHoledTableUnit);
  const std::string module = emit_rom_module(cut.ellipse);
  for (std::size_t word = 0; word < cut.ellipse.words.size(); ++word) {
    const bool has = kHoledTableUnit.table_cells.has(word);
    EXPECT_EQ(cut.ellipse.has(word), has);
    EXPECT_EQ(cut.ellipse.words[word], has ? all.ellipse.words[word] : 0);
    EXPECT_EQ(module.find(fmt::format("8'd{}: data_o", word)) != std::string::npos, has) << word;
  }
  EXPECT_NE(module.find("present_o = 1'b0"), std::string::npos);
  const auto columns = static_cast<std::size_t>(Formats<kHoledTableUnit>::kWeightColumns);
  for (std::size_t word = 0; word < cut.weight.words.size(); ++word) {
    const bool has = kHoledTableUnit.weight_rows.has(word / columns);
    EXPECT_EQ(cut.weight.has(word), has);
    EXPECT_EQ(cut.weight.words[word], has ? all.weight.words[word] : 0);
  }
}

}  // namespace
}  // namespace feline
