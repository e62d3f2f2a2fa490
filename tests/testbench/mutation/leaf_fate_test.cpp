// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "testbench/mutation/fate.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

std::vector<Fate> fates_in(const StageMutants& stage, std::string_view instance) {
  std::vector<Fate> fates;
  for (const Site& site : stage.sites()) {
    if (instance_of(site.cell) != instance) continue;
    for (const Mutant& mutant : site_mutants(site)) {
      if (mutant.kind < Kind::kInvertWhenZero) fates.push_back({mutant, stage.describe(mutant)});
    }
  }
  return fates;
}

// Suites that need Yosys are long ones.
TEST(leaf_fate_long, a_complete_leaf_kills_or_proves_each_and_another_one_only_kills) {
  const TempDir directory;
  const Workshop workshop(FELINE_SOURCE_DIR, directory / "work");
  std::filesystem::create_directories(workshop.directory / "walk");
  const StageMutants stage("walk", FELINE_SOURCE_DIR, workshop.directory / "walk");
  std::vector<Fate> weight = fates_in(stage, "u_probe_weight");
  ASSERT_GT(weight.size(), 100U);
  try_leaves(stage, true, workshop, weight);
  std::size_t killed = 0;
  for (const Fate& fate : weight) {
    EXPECT_NE(fate.tier == kExhaustive, fate.proved()) << fate.name;
    if (fate.proved()) continue;
    ++killed;
    EXPECT_EQ(fate.stage, "walk.probe_weight") << fate.name;
    EXPECT_LT(fate.lookup, 1000U) << fate.name;
  }
  EXPECT_GT(killed, weight.size() / 2);

  std::vector<Fate> position = fates_in(stage, "u_s");
  ASSERT_GT(position.size(), 100U);
  try_leaves(stage, true, workshop, position);
  EXPECT_TRUE(std::ranges::none_of(position, &Fate::proved));
  EXPECT_TRUE(std::ranges::any_of(position, [](const Fate& fate) { return fate.stage == "walk.probe_position"; }));

  // What was found is kept.
  std::vector<Fate> again = fates_in(stage, "u_probe_weight");
  try_leaves(stage, true, workshop, again);
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].lookup, weight[i].lookup) << again[i].name;
}

}  // namespace
}  // namespace feline::mutation
