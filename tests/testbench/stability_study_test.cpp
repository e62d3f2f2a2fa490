// SPDX-License-Identifier: Apache-2.0
// The study of stability and its command, as a user meets them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "testbench/program/commands.h"
#include "testbench/program/stability_report.h"
#include "testbench/stability/study_data.h"
#include "testbench/stability/study_page.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline::stability {
namespace {

const Study& small_study() {
  static const Study study = run_study({150, 7, {}, 1});
  return study;
}

// fProbes = n + 1/2 on the path, where the level falls by log2((n + 3/2)/(n + 1)), between floats that are neighbours.
TEST(stability_study, feline_jumps_where_a_probe_is_added) {
  const std::vector<Path> all = paths(0, 1);
  ASSERT_EQ(all.front().name, "probe_count");
  for (const std::optional<Subject> subject : {std::optional<Subject>(), std::optional(Subject::kStableDouble)}) {
    const std::vector<Jump> jumps = find_jumps(subject, all.front());
    ASSERT_EQ(jumps.size(), 15U);
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      const double n = static_cast<double>(i) + 1;
      EXPECT_EQ(jumps[i].cause, Cause::kProbeCount);
      EXPECT_EQ(std::nextafter(jumps[i].before, INFINITY), jumps[i].after);
      EXPECT_NEAR(jumps[i].after * 256, n + 1.5, 1e-5);
      EXPECT_NEAR(jumps[i].level, -std::log2((n + 1.5) / (n + 1)), 1e-6);
    }
  }
}

TEST(stability_study, every_cause_is_found) {
  std::set<std::pair<int, Cause>> found;
  for (const JumpRow& row : small_study().jumps) {
    found.insert({row.subject ? static_cast<int>(*row.subject) : -1, row.cause});
    EXPECT_TRUE(row.cause != Cause::kMantissa || row.worst_exact_level < 1e-5);
    if (row.subject == Subject::kStableDouble || row.subject == Subject::kStableFloat32) {
      EXPECT_EQ(row.cause, Cause::kProbeCount);
    }
  }
  const auto table = static_cast<int>(Subject::kUnitTable);
  for (const Cause cause : {Cause::kLongerVector, Cause::kTableCell, Cause::kExponent, Cause::kMantissa}) {
    EXPECT_TRUE(found.contains({table, cause})) << kCauseNames[static_cast<std::size_t>(cause)];
  }
  EXPECT_TRUE(found.contains({static_cast<int>(Subject::kUnitSimple), Cause::kProbeCount}));
  EXPECT_TRUE(found.contains({static_cast<int>(Subject::kPrintedFloat32), Cause::kRounding}));
}

TEST(stability_study, bounds_hold) {
  EXPECT_EQ(small_study().broken(), std::vector<std::string>{});
  EXPECT_GT(bound_count(small_study()), 400U);
  EXPECT_EQ(small_study().classes.size(), case_classes().size());
}

// Bounds a thousandth as wide: every subject and every kind of verdict breaks.
TEST(stability_study, a_tighter_bound_breaks) {
  const Study tight = run_study({50, 7, {}, 1000});
  const std::vector<std::string> broken = tight.broken();
  std::string all;
  for (const std::string& what : broken) all += what + "\n";
  for (const std::string_view subject : kSubjectNames) EXPECT_NE(all.find(subject), std::string::npos) << subject;
  for (const std::string_view metric : {"major radius", "minor radius", "axis", "level", "colour", "a jump of"}) {
    EXPECT_NE(all.find(metric), std::string::npos) << metric;
  }
  const TempDir dir;
  testing::internal::CaptureStdout();
  const int code = report_stability(tight, dir / "", false);
  const std::string text = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, kBroken);
  EXPECT_NE(text.find("BROKEN "), std::string::npos);
  const std::string page = read_bytes(dir / "stability.html");
  EXPECT_NE(page.find(">broken"), std::string::npos);
  EXPECT_EQ(html_fault(page), "");
  EXPECT_EQ(nlohmann::json::parse(read_bytes(dir / "stability.json"))["broken"].size(), broken.size());
}

TEST(stability_study, page_is_whole) {
  const std::string page = to_html(small_study());
  EXPECT_EQ(html_fault(page), "");
  for (const CaseClass& of : case_classes()) EXPECT_NE(page.find(of.name), std::string::npos) << of.name;
  EXPECT_NE(page.find("bounds on this page hold"), std::string::npos);
  EXPECT_EQ(page.find("\"bad\">"), std::string::npos);
  EXPECT_EQ(page, to_html(small_study()));
}

TEST(stability_study, table_for_other_programs) {
  const std::string csv = to_csv(small_study());
  const auto lines = static_cast<std::size_t>(std::ranges::count(csv, '\n'));
  EXPECT_EQ(lines, 1 + case_classes().size() * kSubjects.size() * kMetrics.size());
  std::size_t over = 0;
  for (const JumpRow& row : small_study().jumps) over += row.over_a_step.size();
  const std::string jumps = jumps_to_csv(small_study());
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(jumps, '\n')), 1 + over);
  // Every line has as many fields; quoted ones hold commas.
  bool quoted = false;
  int commas = 0;
  for (const char c : csv) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++commas;
    if (c != '\n') continue;
    EXPECT_EQ(commas, 17);
    commas = 0;
  }
}

feline::Outcome run(const std::string& arguments, const std::string& before = "") {
  return run_program(FELINE_PROGRAM, "stability " + arguments, before);
}

TEST(stability_study, command) {
  const TempDir dir;
  const feline::Outcome outcome = run("--class far,condition --count 20 --json --output " + (dir / "").string());
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_EQ(dir.file_count(), 4);
  EXPECT_EQ(outcome.text, read_bytes(dir / "stability.json"));
  const auto json = nlohmann::json::parse(outcome.text);
  EXPECT_EQ(json["classes"].size(), 2U);
  EXPECT_EQ(json["classes"][0]["name"], "far");
  EXPECT_EQ(json["classes"][0]["lookups"], 20);
  EXPECT_EQ(html_fault(read_bytes(dir / "stability.html")), "");
  const feline::Outcome text = run("--class far --count 20");
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.text.find("All bounds hold"), std::string::npos);
}

TEST(stability_study, bad_use) {
  const TempDir dir;
  const auto refused = [&](const std::string& arguments, const std::vector<std::string>& parts,
                           const std::string& before = "") {
    const feline::Outcome outcome = run(arguments, before);
    EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.text;
    for (const std::string& part : parts) EXPECT_NE(outcome.text.find(part), std::string::npos) << outcome.text;
    EXPECT_EQ(dir.file_count(), 0) << arguments;
  };
  refused("--count 0", {"--count", "0", "1 to 1000000"});
  refused("--count 1000001", {"--count", "1000001", "1 to 1000000"});
  refused("--seed -1", {"--seed", "-1", "0 to 18446744073709551615"});
  refused("--class moon", {"--class", "moon", "condition", "level_boundary"});
  refused("--class far,far", {"--class", "far,far", "each once"});
  refused("--class far,all", {"--class", "far,all"});
  refused("--output /nonexistent", {"/nonexistent", "--output", "directory"});
  const std::string output = "--class far --count 9 --output " + (dir / "").string();
  refused(output, {"File too large"}, "ulimit -f 4;");
  refused(output, {"gnuplot", "gnuplot-nox"}, "PATH=/nonexistent");
}

}  // namespace
}  // namespace feline::stability
