// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "testbench/mutation/fate.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

// Suites that need Yosys are long ones.
TEST(register_fate_long, what_a_register_holds_while_it_is_not_valid_nobody_sees) {
  const TempDir directory;
  const Workshop workshop(FELINE_SOURCE_DIR, directory / "work");
  std::filesystem::create_directories(workshop.directory / "group");
  const StageMutants stage("group", FELINE_SOURCE_DIR, workshop.directory / "group");
  std::vector<Fate> fates;
  for (const Site& site : stage.sites()) {
    const bool is_wanted = site.type == "$logic_and" || site.type == "$dff";
    if (instance_of(site.cell) != "u_products" || site.bits.empty() || !is_wanted) continue;
    for (const Kind kind : {Kind::kZero, Kind::kOne}) {
      const Mutant mutant{site.number, kind, 0, 0};
      fates.push_back({mutant, stage.describe(mutant)});
    }
  }
  prove_registers(stage, workshop, fates);
  const auto proved = [&](std::string_view text) {
    return std::ranges::count_if(
        fates, [&](const Fate& fate) { return fate.name.find(text) != std::string::npos && fate.proved(); });
  };
  const auto count = [&](std::string_view text) {
    return std::ranges::count_if(fates, [&](const Fate& fate) { return fate.name.find(text) != std::string::npos; });
  };
  // It takes data whenever it is ready.
  EXPECT_EQ(proved("$logic_and in u_products at rtl/feline_stream_register.sv:33.9-33.27, port B, bit 0 of 1: one"), 1);
  // It never takes any.
  EXPECT_EQ(proved("$logic_and in u_products at rtl/feline_stream_register.sv:33.9-33.27, port Y, bit 0 of 1: zero"),
            0);
  EXPECT_GT(count("$dff"), 2);
  EXPECT_EQ(proved("$dff"), 0);
}

}  // namespace
}  // namespace feline::mutation
