// SPDX-License-Identifier: Apache-2.0
// Exclusions, figures, what is lost, and the page that shows them.
#include "testbench/coverage/ratchet.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "testbench/coverage/coverage_page.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/temp_dir.h"

namespace feline::coverage {
namespace {

std::vector<Point> three_bits() {
  return {{Kind::kRtlToggle, "u_a.b[0]", "rtl/a.sv", 3, 7},
          {Kind::kRtlToggle, "u_a.b[1]", "rtl/a.sv", 3, 0},
          {Kind::kRtlToggle, "u_a.b[12]", "rtl/a.sv", 3, 0},
          {Kind::kBin, "probes/table, 3", "probes", 0, 1}};
}

std::vector<Exclusion> exclusions_of(const TempDir& directory, const std::string& text) {
  write_bytes(directory / "exclusions", text);
  return read_exclusions(directory / "exclusions");
}

TEST(exclusions, patterns) {
  EXPECT_TRUE(matches("u_a.b[0]", "u_a.b[0]"));
  EXPECT_FALSE(matches("u_a.b[0]", "u_a.b[0].c"));
  EXPECT_TRUE(matches("*.b[*]", "u_a.u_x.b[12]"));
  EXPECT_FALSE(matches("*.b[*]", "u_a.c[12]"));
  EXPECT_TRUE(matches("b[{0..2,12}]", "b[12]"));
  EXPECT_TRUE(matches("b[{0..2,12}]", "b[2]"));
  EXPECT_FALSE(matches("b[{0..2,12}]", "b[3]"));
  EXPECT_FALSE(matches("b[{0..2,12}]", "b[]"));
  EXPECT_FALSE(matches("b{1}", "b12"));
  EXPECT_FALSE(matches("b{1..2}", "b12"));
  EXPECT_TRUE(matches("u_{x.*,y}.c", "u_x.z.c"));
  EXPECT_FALSE(matches("u_{x.*,y}.c", "u_x.z.d"));
  EXPECT_TRUE(matches("{a,ab}c", "abc"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_FALSE(matches("", "a"));
  EXPECT_TRUE(matches("a{b", "a{b"));
  // One after the other this would be tried for ever.
  EXPECT_FALSE(matches(std::string(60, '*') + "{" + std::string(60, '*') + "}b", std::string(60, 'a')));
  EXPECT_TRUE(matches("{,a}b", "b"));
  EXPECT_TRUE(matches("open{brace", "open{brace"));
}

TEST(exclusions, read_and_refused) {
  const TempDir directory;
  const auto exclusions =
      exclusions_of(directory, "# why\n\nrtl_toggle u_a.b[1] -- a -- b\nbin probes/table, 3 -- no\n");
  ASSERT_EQ(exclusions.size(), 2U);
  EXPECT_EQ(exclusions[0].kind, Kind::kRtlToggle);
  EXPECT_EQ(exclusions[0].pattern, "u_a.b[1] -- a");
  EXPECT_EQ(exclusions[0].reason, "b");
  EXPECT_EQ(exclusions[1].pattern, "probes/table, 3");
  EXPECT_EQ(exclusions[1].line, 4);
  for (const char* const line : {"toggle x -- y\n", "rtl_toggle x\n", "rtl_toggle x -- \n", "rtl_toggle\n"}) {
    EXPECT_NE(input_error([&] { exclusions_of(directory, line); }).find("exclusions:1: "), std::string::npos) << line;
  }
  EXPECT_NE(input_error([&] { read_exclusions(directory / "gone"); }).find("open"), std::string::npos);
}

TEST(exclusions, apply_to_what_is_not_reached_and_there) {
  const TempDir directory;
  std::vector<Point> points = three_bits();
  EXPECT_TRUE(exclude(points, exclusions_of(directory, "rtl_toggle u_a.b[{1..20}] -- constant\n")).empty());
  EXPECT_EQ(points[0].excluded, "");
  EXPECT_EQ(points[1].excluded, "constant");
  EXPECT_EQ(points[2].excluded, "constant");

  const auto reached = exclude(points, exclusions_of(directory, "rtl_toggle u_a.b[*] -- constant\n"));
  ASSERT_EQ(reached.size(), 1U);
  EXPECT_NE(reached[0].find("u_a.b[0] was reached, 7 times"), std::string::npos) << reached[0];
  const auto nobody = exclude(points, exclusions_of(directory, "rtl_line u_a.b[1] -- of another kind\n"));
  ASSERT_EQ(nobody.size(), 1U);
  EXPECT_NE(nobody[0].find("names no point"), std::string::npos) << nobody[0];
}

TEST(ratchet, figures_leave_out_what_is_excluded) {
  std::vector<Point> points = three_bits();
  points[1].excluded = "constant";
  const Figures figures = figures_of(points);
  EXPECT_EQ(figures[static_cast<std::size_t>(Kind::kRtlToggle)], (Figure{1, 2, 1}));
  EXPECT_EQ(figures[static_cast<std::size_t>(Kind::kBin)], (Figure{1, 1, 0}));
  EXPECT_EQ(share_text({1, 2, 1}), "50.00 %");
  EXPECT_EQ(share_text({99999, 100000, 0}), "99.99 %");
  EXPECT_EQ(share_text({3, 3, 0}), "100 %");
}

TEST(ratchet, is_read_as_it_was_written) {
  const TempDir directory;
  const Ratchet ratchet = ratchet_of(three_bits());
  write_bytes(directory / "ratchet", to_json(ratchet).dump());
  EXPECT_EQ(read_ratchet(directory / "ratchet"), ratchet);
  EXPECT_TRUE(losses(three_bits(), ratchet).empty());
  for (const char* const hit : {"\"all\"", "-1", "1.5", "1e23"}) {
    write_bytes(directory / "ratchet", fmt::format(R"({{"rtl_line": {{"hit": {}}}}})", hit));
    EXPECT_NE(input_error([&] { read_ratchet(directory / "ratchet"); }).find("rtl_line.hit"), std::string::npos) << hit;
  }
  EXPECT_NE(input_error([&] { read_ratchet(directory / "gone"); }).find("--update"), std::string::npos);
}

TEST(ratchet, names_every_point_that_is_lost) {
  const Ratchet before = ratchet_of(three_bits());
  std::vector<Point> points = three_bits();
  points[0].count = 0;
  const auto lost = losses(points, before);
  ASSERT_EQ(lost.size(), 2U);
  EXPECT_EQ(lost[0], "rtl_toggle not reached: u_a.b[0], rtl/a.sv:3");
  EXPECT_NE(lost[1].find("rtl_toggle: 0 of 3 reached, 1 of 3 before"), std::string::npos) << lost[1];
}

// One more reached does not make up for one that is new and not reached.
TEST(ratchet, a_new_point_must_be_reached) {
  const Ratchet before = ratchet_of(three_bits());
  std::vector<Point> points = three_bits();
  points[1].count = 1;
  points.push_back({Kind::kRtlToggle, "u_new.c", "rtl/new.sv", 1, 0});
  const auto lost = losses(points, before);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0], "rtl_toggle not reached: u_new.c, rtl/new.sv:1");
}

TEST(ratchet, points_that_went_away_want_an_update) {
  const Ratchet before = ratchet_of(three_bits());
  std::vector<Point> points = three_bits();
  points.erase(points.begin());
  const auto lost = losses(points, before);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_NE(lost[0].find("--update"), std::string::npos);
}

TEST(coverage_page, shows_what_is_missing_excluded_and_failing) {
  const TempDir directory;
  std::filesystem::create_directory(directory / "rtl");
  write_bytes(directory / "rtl/a.sv", "module a;\n  // bits\n  logic <b>;\n");
  SourceText sources(directory / "");
  Coverage coverage;
  coverage.points = three_bits();
  coverage.exclusions = exclusions_of(directory, "rtl_toggle u_a.b[12] -- it & nothing else\n");
  coverage.faults = exclude(coverage.points, coverage.exclusions);
  coverage.faults.emplace_back("rtl_toggle: lost");
  coverage.grids.emplace_back("probes", "Probes of a lookup.", BinGrid::Axis{"mode", words({"simple", "table"})},
                              BinGrid::Axis{"probes", numbers(1, 3)});
  coverage.grids.back().count(1, 2);
  const std::string page = coverage_page(coverage, sources);
  EXPECT_EQ(html_fault(page), "");
  for (const char* const text : {"u_a.b[1]", "rtl/a.sv:3", "logic &lt;b&gt;;", "it &amp; nothing else", "50.00 %",
                                 "rtl_toggle: lost", "Probes of a lookup. 1 of 6 reached."}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
  const auto json = coverage_json(coverage);
  EXPECT_EQ(json["rtl_toggle"]["missing"], nlohmann::ordered_json({"u_a.b[1]"}));
  EXPECT_EQ(json["rtl_files"]["rtl/a.sv"]["rtl_toggle"]["total"], 2);
  EXPECT_EQ(json["bins"][0]["counts"][5], 1);
  EXPECT_NE(coverage_text(coverage).find("50.00 %"), std::string::npos);
}

}  // namespace
}  // namespace feline::coverage
