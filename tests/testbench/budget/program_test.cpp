// SPDX-License-Identifier: Apache-2.0
// `feline budget` as a user meets it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/testbench/feline_program.h"
#include "tests/testbench/html_check.h"

namespace feline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSmall = "budget --space small --size 16 --scene repeat --output ";

TEST(budget_program, writes_three_files) {
  const TempDir dir;
  const Outcome outcome = run(kSmall + quoted_path(dir, "out"));
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  for (const char* const name : {"budget.html", "budget.json", "budget.csv"}) {
    EXPECT_NE(outcome.text.find((dir / "out" / name).string()), std::string::npos) << name;
  }
  EXPECT_EQ(html_fault(read_bytes(dir / "out" / "budget.html")), "");
  const std::string written = read_bytes(dir / "out" / "budget.json");
  const auto json = nlohmann::json::parse(written);
  EXPECT_EQ(json["holds"], true);
  EXPECT_EQ(json["scenes"][0]["budgets"].size(), 3U);
  // Again, from the cache: the same; as JSON, too.
  const Outcome again = run(kSmall + quoted_path(dir, "out") + " --json");
  ASSERT_EQ(again.code, 0) << again.text;
  EXPECT_EQ(nlohmann::json::parse(again.text), json);
  EXPECT_EQ(read_bytes(dir / "out" / "budget.json"), written);
}

TEST(budget_program, a_budget_that_none_holds) {
  const TempDir dir;
  const std::string command = kSmall + quoted_path(dir, "out") + " --cost ns --truth box";
  const Outcome none = run(command + " --budget-worst 0");
  EXPECT_EQ(none.code, 1) << none.text;
  EXPECT_NE(none.text.find("none holds"), std::string::npos) << none.text;
  const Outcome both = run(command + " --json --budget-worst 255 --budget-db 0.5,3");
  ASSERT_EQ(both.code, 0) << both.text;
  const auto json = nlohmann::json::parse(both.text);
  EXPECT_EQ(json["scenes"][0]["budgets"].size(), 3U);
  EXPECT_GT(json["scenes"][0]["budgets"][0]["choice"]["ns"], 0);
}

// Killed in the middle, it goes on and gives what it would have given.
TEST(budget_program, goes_on_after_it_was_killed) {
  const TempDir dir;
  const std::string command = "budget --space full --size 12 --scene repeat --json --output ";
  const std::string cache = quoted_path(dir, "out/cache");
  // As soon as a few variants are measured.
  const Outcome killed = run_program(
      FELINE_PROGRAM, command + quoted_path(dir, "out") + " >/dev/null & pid=$!\n" + "while kill -0 $pid && [ $(ls " +
                          cache + " | wc -l) -lt 5 ]; do sleep 0.02; done\n" + "kill -KILL $pid; wait $pid; exit $?");
  EXPECT_EQ(killed.code, 128 + 9) << killed.text;
  EXPECT_FALSE(fs::exists(dir / "out" / "budget.json"));
  const auto known = std::distance(fs::directory_iterator(dir / "out" / "cache"), {});
  const Outcome resumed = run(command + quoted_path(dir, "out"));
  ASSERT_EQ(resumed.code, 0) << resumed.text;
  EXPECT_GT(std::distance(fs::directory_iterator(dir / "out" / "cache"), {}), known);
  const Outcome whole = run(command + quoted_path(dir, "other"));
  ASSERT_EQ(whole.code, 0) << whole.text;
  EXPECT_EQ(resumed.text, whole.text);
}

TEST(budget_program, refuses_and_says_what_is_legal) {
  const TempDir dir;
  const std::string output = " --output " + quoted_path(dir, "out");
  expect_refused(dir, "budget --scene moon" + output, {"moon", "bricks"});
  expect_refused(dir, "budget --scene bricks,bricks" + output, {"--scene", "each once"});
  expect_refused(dir, "budget --size 0" + output, {"--size", "0", "1 to 16384"});
  expect_refused(dir, "budget --budget-db -1" + output, {"--budget-db", "-1", "0 to"});
  expect_refused(dir, "budget --budget-db 0.1,nan" + output, {"--budget-db", "nan", "0 to"});
  expect_refused(dir, "budget --budget-worst 256" + output, {"--budget-worst", "256", "0 to 255"});
  expect_refused(dir, "budget --truth lanczos" + output, {"--truth", "lanczos", "gaussian, box"});
  expect_refused(dir, "budget --cost money" + output, {"--cost", "money", "cycles, gates, ns"});
  expect_refused(dir, "budget --space outer" + output, {"--space", "outer", "small, full"});
  expect_refused(dir, "budget --kernel box" + output, {"--kernel", "box", "bilinear, gaussian"});
  expect_refused(dir, "budget --seed -1" + output, {"--seed", "-1", "0 to"});
  expect_refused(dir, "budget --gbuffer a.exr" + output, {"--texture", "go together"});
  const std::string small = "budget --space small --size 8 --scene repeat";
  expect_refused(dir, small + " --output /proc/none/out", {"--output", "/proc/none/out", "directory"});
  write_bytes(dir / "file", "");
  expect_refused(dir, small + " --output " + quoted_path(dir, "file"), {"--output", "file", "directory"});
  expect_refused(dir, small + output, {"gnuplot-nox"}, "PATH=/none");
  ASSERT_TRUE(fs::create_directory(dir / "out"));
  expect_refused(dir, small + output + " --cache " + quoted_path(dir, "file"), {"cache", "file", "directory"});
  fs::create_directory(dir / "out" / "budget.json");
  expect_refused(dir, small + output, {"budget.json"});
  EXPECT_FALSE(fs::exists(dir / "out" / "budget.html"));
}

}  // namespace
}  // namespace feline
