// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/savings.h"

#include <gtest/gtest.h>

#include "tables/formats.h"
#include "tests/support/pruned_configs.h"
#include "tests/testbench/feline_program.h"

namespace feline {
namespace {

Savings made_up() {
  Savings savings;
  savings.scene = "moon, \"full\"";
  savings.width = 4;
  savings.height = 2;
  savings.config = kSimpleUnit;
  savings.check.lookups = savings.check.identical = 8;
  savings.check.probes = 20;
  savings.check.cycles = 100;
  savings.gaussian.mean_square = 1e-4;
  savings.box.mean_square = 1e-3;
  savings.full = {"all", 1000, 2000, 100, 8000, 64, {{8, 8, 10}}};
  savings.pruned = {"all", 600, 1500, 90, 800, 64, {{8, 8, 4}, {7, 4, 1}}};
  return savings;
}

TEST(savings, markdown) {
  const std::string text = savings_markdown({made_up()});
  EXPECT_NE(text.find("| the full unit | 16 probes, 15 levels, 14 size bits, 6 exponent bits, "), std::string::npos);
  EXPECT_NE(text.find(", 256 table cells, 77 weight rows, 25 features | 1000 | 2000 | 1000 | 10 |"), std::string::npos)
      << text;
  EXPECT_NE(text.find("| 5 probes, 5 levels, 7 size bits, 3 exponent bits, "), std::string::npos) << text;
  EXPECT_NE(text.find(", 0 table cells, "), std::string::npos) << text;
  EXPECT_NE(text.find("| 600 (-40 %) | 1500 (-25 %) | 100 | 5 | 12.5 | 40.0 dB | 30.0 dB | 8 of 8 |"),
            std::string::npos)
      << text;
}

TEST(savings, csv_and_json_have_every_figure) {
  const std::string csv = savings_csv({made_up()});
  EXPECT_NE(csv.find("\n\"moon, \"\"full\"\"\",4,2,1,8,8,5,5,7,3,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",1000,2000,100,8000,64,10,600,1500,90,800,64,5,2.5,12.5,40,30\n"), std::string::npos) << csv;
  const auto json = savings_json({made_up()});
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["check"]["identical"], 8);
  EXPECT_EQ(json[0]["pruned"]["cells"], 600);
  EXPECT_EQ(json[0]["full"]["cells"], 1000);
  EXPECT_EQ(json[0]["configuration"]["max_probes"], 5);
}

TEST(savings, hold_only_when_every_pixel_is_the_same) {
  EXPECT_TRUE(made_up().holds());
  for (std::uint64_t PrunedCheck::*const fault :
       {&PrunedCheck::silent, &PrunedCheck::misjudged, &PrunedCheck::mismatches}) {
    Savings savings = made_up();
    savings.check.*fault = 1;
    EXPECT_FALSE(savings.holds());
  }
  Savings flagged = made_up();
  flagged.check.identical -= 1;
  EXPECT_FALSE(flagged.holds());
}

TEST(savings_program, refuses_and_says_what_is_legal) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "savings");
  expect_refused(dir, "savings --scene moon" + output, {"moon", "bricks"});
  expect_refused(dir, "savings --mode trot" + output, {"--mode", "trot", "simple"});
  expect_refused(dir, "savings --size 0" + output, {"--size", "0"});
  expect_refused(dir, "savings --output /proc/savings", {"/proc/savings"});
  expect_refused(dir, "savings --library /nonexistent.lib" + output, {"--library", "/nonexistent.lib"});
  expect_refused(dir, "savings --source /nonexistent" + output, {"--source", "/nonexistent"});
}

// The areas of the whole unit, which take two minutes, and what one scene saves of them.
TEST(savings_long, of_one_scene) {
  const TempDir dir;
  const Outcome whole = run("area --json --cache " + quoted_path(dir, "savings/cache"));
  ASSERT_EQ(whole.code, 0) << whole.text;
  const auto area = nlohmann::json::parse(whole.text);
  ASSERT_EQ(area["stages"].size(), 10U);
  EXPECT_EQ(area["stages"].front()["stage"], "group");
  EXPECT_EQ(area["stages"].back()["stage"], "rest");
  EXPECT_LT(area["stages"].back()["gate_equivalents"], 500) << "cells that no stage has";

  const Outcome outcome = run("savings --json --scene runway --size 32 --output " + quoted_path(dir, "savings"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0]["holds"], true);
  EXPECT_EQ(json[0]["check"]["identical"], 32 * 32);
  EXPECT_EQ(json[0]["check"]["mismatches"], 0);
  const auto& full = json[0]["full"];
  const auto& pruned = json[0]["pruned"];
  double cells = 0;
  for (const auto& stage : area["stages"]) cells += stage["cells"].get<double>();
  EXPECT_EQ(full["cells"], cells);
  EXPECT_LT(pruned["cells"], 0.7 * cells);
  EXPECT_GT(pruned["cells"], 0.2 * cells);
  constexpr std::int64_t kLines = 16;
  constexpr std::int64_t kBitsOfLine = 512 + Formats<kDefaultConfig>::kLine.width();
  EXPECT_EQ(full["memory_bits"], 2 * kLines * kBitsOfLine);
  // Filter's 28 interpolations and accumulate's products are there, whatever else is.
  EXPECT_GE(full["multiplier_count"], 28 + 4);
  EXPECT_EQ(nlohmann::json::parse(read_bytes(dir / "savings" / "savings.json")), json);
  EXPECT_NE(read_bytes(dir / "savings" / "savings.md").find("| runway |"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(dir / "savings" / "runway" / "unit.h"));
}

}  // namespace
}  // namespace feline
