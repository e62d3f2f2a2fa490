// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tables/emit.h"

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
  EXPECT_CHANGES(features.ext = false)
  EXPECT_CHANGES(features.simple_feline = false)
  EXPECT_CHANGES(features.table_feline = false)
  EXPECT_CHANGES(features.gaussian = false)
  EXPECT_CHANGES(features.srgb = false)
  EXPECT_CHANGES(features.mirrored_repeat = false)
  EXPECT_CHANGES(features.clamp_to_border = false)
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

}  // namespace
}  // namespace feline
