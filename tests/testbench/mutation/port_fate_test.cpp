// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "testbench/mutation/fate.h"
#include "tests/testbench/temp_dir.h"

namespace feline::mutation {
namespace {

const Site& port_of_stage(const StageMutants& unit, std::string_view module, std::string_view port) {
  const auto is_it = [&](const Site& site) { return site.type == module && site.port == port; };
  const auto found = std::ranges::find_if(unit.sites(), is_it);
  if (found == unit.sites().end()) throw std::runtime_error("no such port");
  return *found;
}

// Suites that need Yosys are long ones.
TEST(port_fate_long, what_a_stage_never_gets_makes_no_difference) {
  const TempDir directory;
  const Workshop workshop(FELINE_SOURCE_DIR, directory / "work");
  std::filesystem::create_directories(workshop.directory / kUnitName);
  const StageMutants unit(std::string(kUnitName), FELINE_SOURCE_DIR, workshop.directory / kUnitName);
  const Site& plan = port_of_stage(unit, "feline_walk", "plan_i");
  // After the tag, 16 bits, status, of which bit 2 says that something is not supported: never, in all configurations
  // but small ones.
  const std::uint32_t unsupported = plan.width - 18;
  const Site& texels = port_of_stage(unit, "feline_filter", "fetch_i");
  const Site& address = port_of_stage(unit, "feline_fetch", "address_i");
  std::vector<Fate> fates;
  fates.push_back({{plan.number, Kind::kZero, unsupported, 0}, "never one"});
  fates.push_back({{plan.number, Kind::kOne, unsupported, 0}, "always one"});
  fates.push_back({{texels.number, Kind::kInvert, 0, 0}, "another texel"});
  fates.push_back({{texels.number, Kind::kInvert, 0, 0}, "killed"});
  fates.back().tier = "smoke";
  // Of fetch, whose memories are too large to follow.
  fates.push_back({{address.number, Kind::kZero, address.width - 18, 0}, "never one"});
  prove_ports(unit, workshop, fates);
  EXPECT_TRUE(fates[0].proved());
  EXPECT_FALSE(fates[1].proved());
  EXPECT_FALSE(fates[2].proved());
  EXPECT_NE(fates[2].differs, "");
  EXPECT_FALSE(fates[3].proved());
  EXPECT_EQ(fates[3].differs, "");
  EXPECT_TRUE(fates[4].proved());
}

}  // namespace
}  // namespace feline::mutation
