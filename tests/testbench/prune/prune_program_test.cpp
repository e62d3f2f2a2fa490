// SPDX-License-Identifier: Apache-2.0
// `feline prune` as a user meets it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "testbench/prune/profile_json.h"
#include "tests/testbench/feline_program.h"

namespace feline {
namespace {

TEST(prune_program, writes_a_unit) {
  const TempDir dir;
  const Outcome outcome =
      run("prune --no-check --json --scene repeat --size 16 --mode simple --output " + quoted_path(dir, "unit"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  EXPECT_EQ(json["profiled_lookups"], 256);
  EXPECT_EQ(json["configuration"]["features"]["simple_feline"], true);
  EXPECT_EQ(json["configuration"]["features"]["table_feline"], false);
  EXPECT_TRUE(json["check"].is_null());
  EXPECT_FALSE(json.contains("holds"));
  EXPECT_EQ(nlohmann::json::parse(read_bytes(dir / "unit" / "prune.json")), json);
  for (const char* const name : {"unit.h", "profile.json", "generated/feline_pkg.sv", "generated/feline_rom_ellipse.sv",
                                 "generated/roms.json"}) {
    EXPECT_TRUE(std::filesystem::exists(dir / "unit" / name)) << name;
  }
  EXPECT_NE(read_bytes(dir / "unit" / "generated" / "feline_pkg.sv").find("FeatureTableFeline = 1'b0"),
            std::string::npos);
  // The profile gives the same unit.
  const Outcome again =
      run("prune --json --profile " + quoted_path(dir, "unit/profile.json") + " --output " + quoted_path(dir, "again"));
  ASSERT_EQ(again.code, 0) << again.text;
  EXPECT_EQ(read_bytes(dir / "again" / "unit.h"), read_bytes(dir / "unit" / "unit.h"));
}

TEST(prune_program, refuses_and_says_what_is_legal) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "unit");
  expect_refused(dir, "prune --scene moon" + output, {"moon", "bricks"});
  expect_refused(dir, "prune --scene bricks --frames 1" + output, {"--frames", "1", "0 to 0 of bricks"});
  expect_refused(dir, "prune --scene spin --frames 5:2" + output, {"--frames", "5:2", "FIRST:LAST, 0 to 7"});
  expect_refused(dir, "prune --profile /nonexistent.json" + output, {"/nonexistent.json"});
  expect_refused(dir, "prune --gbuffer /nonexistent.exr --texture /nonexistent.png" + output, {"/nonexistent.exr"});
  expect_refused(dir, "prune --scene repeat --no-check --output /proc/unit", {"/proc/unit", "--output"});
  expect_refused(dir, "activity --unit " + quoted_path(dir, "none"), {"none", "unit.h", "feline prune"});
}

TEST(prune_program, refuses_a_profile_of_nothing) {
  const TempDir dir;
  write_bytes(dir / "empty.json", profile_to_json(Profile{}));
  expect_refused(dir, "prune --profile " + quoted_path(dir, "empty.json") + " --output " + quoted_path(dir, "unit"),
                 {"lookups", "got 0", "at least 1"});
}

// The verdict on another unit must not stay beside a new one.
TEST(prune_program, an_old_verdict_goes) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "unit");
  ASSERT_EQ(run("prune --no-check --scene repeat --size 8" + output).code, 0);
  ASSERT_TRUE(std::filesystem::exists(dir / "unit" / "prune.json"));
  // No sources to build the check from.
  ASSERT_EQ(run("prune --scene bricks --size 8 --source /nonexistent" + output).code, 2);
  EXPECT_FALSE(std::filesystem::exists(dir / "unit" / "prune.json"));
}

TEST(prune_program, says_when_there_are_no_sources) {
  const TempDir dir;
  const Outcome outcome =
      run("prune --scene repeat --size 8 --source /nonexistent --output " + quoted_path(dir, "unit"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.text.find("--source"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("/nonexistent"), std::string::npos) << outcome.text;
}

// A unit of one frame, built: on that frame the full unit's pixels; on frames nearer and farther, and in another mode,
// flags where it lacks something, and nothing wrong without one.
TEST(prune_program_long, proves_the_unit_and_flags_what_leaves_it) {
  const TempDir dir;
  const std::string unit = " --json --output " + quoted_path(dir, "unit");
  const Outcome proved = run("prune --scene runway --size 64 --mode simple" + unit);
  ASSERT_EQ(proved.code, 0) << proved.text;
  const auto own = nlohmann::json::parse(proved.text)["check"];
  EXPECT_EQ(own["lookups"], 4096);
  EXPECT_EQ(own["identical"], 4096);
  EXPECT_EQ(own["flagged"], 0);
  EXPECT_EQ(own["mismatches"], 0);

  const Outcome held_out = run("prune --profile " + quoted_path(dir, "unit/profile.json") +
                               " --scene runway,runway_steep,text --size 48 --mode simple,table" + unit);
  ASSERT_EQ(held_out.code, 0) << held_out.text;
  const auto others = nlohmann::json::parse(held_out.text)["check"];
  EXPECT_EQ(others["lookups"], 6 * 48 * 48);
  EXPECT_EQ(others["silent"], 0);
  EXPECT_EQ(others["misjudged"], 0);
  EXPECT_GT(others["flagged"], 48 * 48);
  EXPECT_GT(others["identical"], 48 * 48);
  EXPECT_EQ(others["outside"], others["flagged"].get<int>() + others["refused"].get<int>());
}

// A table with holes, in RTL: a unit that does all of a scene in Simple mode, and has the cells of another one. What
// meets a hole is flagged by RTL and model alike.
TEST(prune_program_long, proves_a_table_with_holes) {
  const TempDir dir;
  ASSERT_EQ(run("profile --scene curves --size 32 --mode simple --output " + quoted_path(dir, "simple")).code, 0);
  ASSERT_EQ(run("profile --scene spin --frames 0 --size 32 --mode table --output " + quoted_path(dir, "table")).code,
            0);
  const Outcome outcome = run("prune --json --scene curves --size 32 --mode simple,table --profile " +
                              quoted_path(dir, "simple/profile.json") + " --profile " +
                              quoted_path(dir, "table/profile.json") + " --output " + quoted_path(dir, "unit"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto json = nlohmann::json::parse(outcome.text);
  EXPECT_EQ(json["holds"], true);
  const auto& check = json["check"];
  EXPECT_EQ(check["lookups"], 2 * 32 * 32);
  EXPECT_EQ(check["mismatches"], 0);
  EXPECT_EQ(check["silent"], 0);
  EXPECT_EQ(check["misjudged"], 0);
  EXPECT_GT(check["flagged"], 500);
  EXPECT_GE(check["identical"], 32 * 32);
}

}  // namespace
}  // namespace feline
