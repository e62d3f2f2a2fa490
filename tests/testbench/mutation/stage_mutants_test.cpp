// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/stage_mutants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "testbench/mutation/mutation_report.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

// Suites that need Yosys are long ones.
TEST(stage_mutants_long, every_site_has_a_name_of_its_own) {
  const TempDir directory;
  const StageMutants stage("group", FELINE_SOURCE_DIR, directory / ".");
  std::set<std::string> names;
  std::size_t inner = 0;
  for (const Site& site : stage.sites()) {
    if (site.bits.empty()) continue;
    const std::string name = stage.describe(site_mutants(site).back());
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(stage.has(name)) << name;
    // The place is where it was written, not where its module is an instance.
    if (name.find("u_bit_length at rtl/feline_bit_length.sv:") != std::string::npos) ++inner;
  }
  EXPECT_GT(names.size(), 500U);
  EXPECT_GT(inner, 4U);
  ASSERT_FALSE(names.empty());
  EXPECT_FALSE(stage.has(*names.begin() + "s"));
  EXPECT_FALSE(stage.has("$add at rtl/feline_walk.sv:1.1-1.2, port A, bit 0 of 4: zero"));
}

TEST(stage_mutants_long, reasons_are_of_mutants_that_there_are) {
  const std::filesystem::path source = FELINE_SOURCE_DIR;
  std::size_t reasons = 0;
  for (const auto& [name, mutants] : read_known_survivors(source / "testbench/mutation/survivors.json")) {
    const TempDir directory;
    const StageMutants stage(name, source, directory / ".");
    for (const auto& [mutant, reason] : mutants) EXPECT_TRUE(stage.has(mutant)) << name << ": " << mutant;
    reasons += mutants.size();
  }
  EXPECT_GT(reasons, 0U);
}

TEST(stage_mutants_long, tells_what_may_touch_a_stream) {
  const TempDir directory;
  const StageMutants stage("group", FELINE_SOURCE_DIR, directory / ".");
  std::size_t in_stream = 0;
  for (const Site& site : stage.sites()) {
    const Mutant mutant{site.number, Kind::kInvert, 0, 0};
    const bool in_register = stage.describe(mutant).find("rtl/feline_stream_register.sv") != std::string::npos;
    in_stream += in_register ? 1U : 0U;
    const bool in_arithmetic = stage.describe(mutant).find("rtl/feline_round_magnitude.sv") != std::string::npos;
    if (in_register) {
      EXPECT_TRUE(stage.in_stream(mutant)) << stage.describe(mutant);
    }
    if (in_arithmetic) {
      EXPECT_FALSE(stage.in_stream(mutant)) << stage.describe(mutant);
    }
  }
  EXPECT_GT(in_stream, 10U);
  std::set<std::string> ports;
  for (const Site& port : stage.ports()) {
    if (stage.in_stream({port.number, Kind::kOne, 0, 0})) ports.insert(port.port);
  }
  EXPECT_EQ(ports,
            (std::set<std::string>{"rst_i", "request_valid_i", "request_ready_o", "group_valid_o", "group_ready_i"}));
}

}  // namespace
}  // namespace feline::mutation
