// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "testbench/mutation/fate.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

// Suites that need Yosys are long ones.
TEST(logic_fate_long, nobody_sees_a_word_that_nothing_reads) {
  const TempDir directory;
  const Workshop workshop(FELINE_SOURCE_DIR, directory / "work");
  std::filesystem::create_directories(workshop.directory / "walk");
  const StageMutants stage("walk", FELINE_SOURCE_DIR, workshop.directory / "walk");
  ASSERT_EQ(stage.roms().size(), 1U);
  // One probe reads column 0 of row 0; two read column 1 of rows 1 to 4, of nine columns each.
  std::vector<Fate> fates;
  for (const std::uint32_t word : {0U, 1U, 9U, 10U}) {
    for (const std::uint32_t bit : {0U, 8U}) {
      const Mutant mutant{1, Kind::kRomBit, bit, word};
      fates.push_back({mutant, stage.describe(mutant)});
    }
  }
  fates.push_back({{1, Kind::kRomBit, 3, 1}, "killed"});
  fates.back().tier = "smoke";
  compare_logic(stage, Fate::Logic::kSame, workshop, fates);
  for (const Fate& fate : fates) EXPECT_FALSE(fate.proved()) << fate.name;
  compare_logic(stage, Fate::Logic::kUnobserved, workshop, fates);
  for (const Fate& fate : fates) {
    const bool is_read = fate.mutant.control == 0 || fate.mutant.control == 10;
    EXPECT_EQ(fate.proved(), !is_read && fate.tier.empty()) << fate.name;
  }
}

}  // namespace
}  // namespace feline::mutation
