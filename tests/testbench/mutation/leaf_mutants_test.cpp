// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/leaf_mutants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "testbench/mutation/leaf_trial.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

// Suites that need Yosys are long ones. A leaf whose modules have other parameters would match nothing.
TEST(leaf_mutants_long, every_leaf_has_mutants_of_its_stage) {
  const TempDir directory;
  std::map<std::string, std::set<std::string_view>> wrappers;
  for (const prove::Leaf& leaf : prove::all_leaves()) wrappers[std::string(leaf.stage())].insert(leaf.wrapper);
  for (const auto& [name, of_stage] : wrappers) {
    const StageMutants stage(name, FELINE_SOURCE_DIR, directory / ".");
    for (const std::string_view wrapper : of_stage) {
      // A ROM alone: nothing of it is an operator.
      if (wrapper == "kernel_weight") continue;
      const LeafMutants in_leaf(stage, wrapper, FELINE_SOURCE_DIR, directory / ".");
      const bool is_any = std::ranges::any_of(stage.sites(), [&](const Site& site) {
        return in_leaf.in_leaf({site.number, Kind::kInvert, 0, 0}).has_value();
      });
      EXPECT_TRUE(is_any) << wrapper;
      // What a leaf is complete in is there.
      for (const prove::Leaf& leaf : prove::all_leaves()) {
        if (leaf.wrapper != wrapper || leaf.complete_in.empty()) continue;
        const bool is_in = std::ranges::any_of(stage.sites(), [&](const Site& site) {
          const auto own = in_leaf.in_leaf({site.number, Kind::kInvert, 0, 0});
          return own && in_leaf.instance(*own) == leaf.complete_in;
        });
        EXPECT_TRUE(is_in) << leaf.name;
      }
    }
  }
}

TEST(leaf_mutants_long, of_walk_are_those_of_its_position_in_either_direction) {
  const TempDir directory;
  const StageMutants stage("walk", FELINE_SOURCE_DIR, directory / ".");
  const TempDir leaf_directory;
  const LeafMutants in_leaf(stage, "probe_position", FELINE_SOURCE_DIR, leaf_directory / ".");
  std::map<std::uint32_t, std::set<std::string>> instances;  // by the leaf's site
  std::size_t others = 0;
  for (const Site& site : stage.sites()) {
    const auto own = in_leaf.in_leaf({site.number, Kind::kInvert, 0, 0});
    const bool is_position = site.source.find("/rtl/feline_probe_position.sv:") != std::string::npos;
    EXPECT_EQ(own.has_value(), is_position) << site.cell;
    if (own) {
      instances[own->site].insert(instance_of(site.cell));
    } else {
      ++others;
    }
  }
  EXPECT_GT(instances.size(), 5U);
  EXPECT_GT(others, 50U);
  for (const auto& [site, paths] : instances) EXPECT_EQ(paths.size(), 2U) << site;  // s and t
  EXPECT_FALSE(in_leaf.in_leaf({1, Kind::kRomBit, 0, 0}).has_value());
}

TEST(leaf_mutants_long, of_a_leaf_are_found_by_its_inputs) {
  const TempDir directory;
  const StageMutants stage("walk", FELINE_SOURCE_DIR, directory / ".");
  const TempDir leaf_directory;
  const LeafMutants in_leaf(stage, "probe_position", FELINE_SOURCE_DIR, leaf_directory / ".");
  std::vector<Mutant> mutants;
  std::vector<std::uint64_t> codes;
  for (const Site& site : stage.sites()) {
    if (site.bits.empty()) continue;
    const auto own = in_leaf.in_leaf({site.number, Kind::kInvert, site.bits[0].place, 0});
    if (!own || std::ranges::find(mutants, *own) != mutants.end()) continue;
    mutants.push_back(*own);
    codes.push_back(code(*own));
  }
  codes.push_back(0);  // no mutant
  const auto& leaves = prove::all_leaves();
  const auto leaf = std::ranges::find(leaves, "walk.probe_position", &prove::Leaf::name);
  ASSERT_NE(leaf, leaves.end());
  const auto found = differing_inputs(*leaf, in_leaf.logic(mutants), codes, std::uint64_t{1} << 16);
  for (std::size_t i = 0; i + 1 < found.size(); ++i) EXPECT_TRUE(found[i].has_value()) << codes[i];
  EXPECT_FALSE(found.back().has_value());
}

}  // namespace
}  // namespace feline::mutation
