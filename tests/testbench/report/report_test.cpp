// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/report.h"

#include <gtest/gtest.h>

#include <limits>

#include "testbench/report/tables.h"
#include "tests/testbench/html_check.h"
#include "tests/testbench/report/surveys.h"

namespace feline {
namespace {

constexpr double kPerfect = std::numeric_limits<double>::infinity();

// All that may be odd: every kind of contestant, a picture without error, a sequence, names of any kind.
Survey odd_survey() {
  Cell unit = cell_of("unit_table", 31, 5);
  unit.rtl_cycles = 12.5;
  Cell library = cell_of("openimageio", 29, 4);
  library.cost = {};
  library.probes_png.clear();
  Cell moving = cell_of("ewa", 40, 9);
  moving.gaussian.shimmer = 0.0004;
  moving.box.shimmer = 0.0001;
  ExhibitResult still = result_of("it's, a \"view\" <&>", {cell_of("nearest", kPerfect), unit, library,
                                                           cell_of("feline_table", 32, 5), cell_of("ewa", kPerfect)});
  still.splits = {{"bilinear", 1e-4, 2e-5, 3e-5}, {"gaussian", 0, 0, 0}};
  still.plan.perspective = false;
  ExhibitResult sequence = result_of("spin", {moving, unit, library, cell_of("feline_table", 33, 5)});
  sequence.plan.frame_count = 8;
  return survey_of({std::move(still), std::move(sequence)});
}

// The fields of a line by RFC 4180.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      fields.back() += line[++i];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) rows.push_back(fields_of(line));
  return rows;
}

bool has_only_numbers(const nlohmann::ordered_json& json) {
  if (json.is_number_float()) return std::isfinite(json.get<double>());
  if (!json.is_structured()) return true;
  return std::ranges::all_of(json, has_only_numbers);
}

TEST(report_report, every_csv_row_is_as_long_as_the_header) {
  const auto rows = rows_of(make_report(odd_survey()).csv);
  ASSERT_EQ(rows.size(), 1U + 5 + 4 + 4);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(rows[1][0], "it's, a \"view\" <&>");
  const auto field = [&](std::size_t row, std::string_view name) {
    return rows[row][static_cast<std::size_t>(std::ranges::find(rows[0], name) - rows[0].begin())];
  };
  EXPECT_EQ(field(1, "psnr_gaussian"), "");
  EXPECT_EQ(field(1, "rmse_gaussian"), "0");
  EXPECT_EQ(field(1, "rtl_cycles"), "");
  EXPECT_EQ(field(2, "filter"), "unit_table");
  EXPECT_EQ(field(2, "rtl_cycles"), "12.5");
  EXPECT_EQ(field(2, "texels"), "40");
  EXPECT_NEAR(std::stod(field(2, "psnr_box")), 31, 1e-9);
  EXPECT_EQ(field(3, "filter"), "openimageio");
  EXPECT_EQ(field(3, "texels"), "");
  EXPECT_EQ(field(6, "filter"), "ewa");
  EXPECT_NEAR(std::stod(field(6, "shimmer_gaussian")), 0.02, 1e-12);
  EXPECT_NEAR(std::stod(field(6, "shimmer_box")), 0.01, 1e-12);
  // What both scenes have, together.
  for (std::size_t row = 10; row <= 13; ++row) EXPECT_EQ(field(row, "scene"), "all");
  EXPECT_EQ(field(10, "filter"), "unit_table");
  EXPECT_EQ(field(10, "texels"), "40");
}

TEST(report_report, csv_names_the_fronts) {
  const auto rows = rows_of(make_report(odd_survey()).csv);
  // Nearest and EWA are without error and as cheap as each other: no other is on a front, but for the only one with
  // RTL.
  const std::string all = "gaussian:nanoseconds gaussian:cycles gaussian:texels box:nanoseconds box:cycles box:texels";
  EXPECT_EQ(rows[1].back(), all);
  EXPECT_EQ(rows[2].back(), "gaussian:rtl_cycles box:rtl_cycles");
  EXPECT_EQ(rows[3].back(), "");
  EXPECT_EQ(rows[4].back(), "");
  EXPECT_EQ(rows[5].back(), all);
}

TEST(report_report, json_is_json) {
  const Report report = make_report(odd_survey());
  EXPECT_TRUE(has_only_numbers(report.json));
  EXPECT_EQ(report.json.dump().find("null"), std::string::npos);
  EXPECT_EQ(nlohmann::ordered_json::parse(report.json.dump()), report.json);
  const auto& still = report.json["scenes"][0];
  EXPECT_EQ(still["truth"]["projection"], "affine");
  EXPECT_EQ(report.json["scenes"][1]["truth"]["projection"], "exact");
  EXPECT_FALSE(still["filters"][0]["gaussian"].contains("psnr"));
  EXPECT_EQ(still["filters"][1]["rtl_cycles"], 12.5);
  EXPECT_FALSE(still["filters"][2].contains("texels"));
  EXPECT_NEAR(still["unit_error"][0]["feline_rmse"], 0.01, 1e-15);
  EXPECT_NEAR(report.json["scenes"][1]["filters"][0]["gaussian"]["shimmer"], 0.02, 1e-15);
  EXPECT_EQ(report.json["claims"].size(), 9U);
  ASSERT_EQ(report.json["all_scenes"].size(), 4U);
  EXPECT_EQ(report.json["all_scenes"][0]["filter"], "unit_table");
  EXPECT_EQ(still["filters"][1]["pareto"], (std::vector<std::string>{"gaussian:rtl_cycles", "box:rtl_cycles"}));
  EXPECT_TRUE(still["filters"][2]["pareto"].empty());
}

TEST(report_report, the_page_is_whole_and_alone) {
  const Survey survey = odd_survey();
  const std::string html = make_report(survey).html;
  EXPECT_EQ(html_fault(html), "");
  for (const ExhibitResult& result : survey.results) {
    for (const Cell& cell : result.cells) {
      EXPECT_NE(html.find("<td>" + cell.contestant + "</td>"), std::string::npos) << cell.contestant;
      EXPECT_NE(html.find(cell.contestant + ":"), std::string::npos) << cell.contestant;
    }
    EXPECT_NE(html.find("<h2>" + page::escape(result.plan.name) + "</h2>"), std::string::npos);
  }
  // "All scenes together" is of those that every scene has.
  EXPECT_NE(html.find("All scenes together"), std::string::npos);
}

TEST(report_report, nothing_on_the_page_is_no_number) {
  Survey survey = survey_of(
      {result_of("own", {cell_of("feline_table", kPerfect), cell_of("unit_table", kPerfect),
                         cell_of("feline_table_gaussian", kPerfect), cell_of("unit_table_gaussian", kPerfect)})});
  survey.results[0].truth->gaussian_error = survey.results[0].truth->box_error = 0;
  survey.results[0].splits = {{"bilinear", 0, 0, 0}, {"gaussian", 0, 0, 0}};
  const Report report = make_report(survey);
  EXPECT_TRUE(report.holds);
  for (const char* const text : {"nan dB", ">nan<", ">-nan<", ">+nan<", "inf dB", ">inf<"}) {
    EXPECT_EQ(report.html.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(report.html.find("class=\"number bad\""), std::string::npos);
}

TEST(report_report, what_the_budget_did_not_allow) {
  Survey survey = survey_of({result_of("bricks", {cell_of("ewa", 30)}), result_of("spin", {})});
  survey.results[1].truth.reset();
  survey.missing = 7;
  const Report report = make_report(survey);
  EXPECT_EQ(html_fault(report.html), "");
  EXPECT_NE(report.html.find("7 pieces of work were not begun"), std::string::npos);
  EXPECT_NE(report.html.find("Not measured within the budget."), std::string::npos);
  EXPECT_EQ(report.html.find("All scenes together"), std::string::npos);
  EXPECT_NE(report.text.find("7 pieces"), std::string::npos);
  EXPECT_EQ(report.json["missing"], 7);
  EXPECT_FALSE(report.json["scenes"][1].contains("truth"));
  EXPECT_TRUE(report.holds);
}

TEST(report_report, text_is_sorted_by_error) {
  const std::string text =
      make_report(survey_of({result_of("bricks", {cell_of("texram", 20), cell_of("ewa", 40), cell_of("ext", 30)})}))
          .text;
  EXPECT_LT(text.find("ewa"), text.find("ext"));
  EXPECT_LT(text.find("ext"), text.find("texram"));
}

TEST(report_tables, green_is_on_a_front) {
  std::vector<Cell> cells{cell_of("trilinear", 20, 1), cell_of("texram", 15, 3), cell_of("ewa", 40, 9)};
  cells.push_back(cell_of("openimageio", 30, 2));
  const page::Table table = standing_table(cells);
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table.rows[0][0].text, "ewa");
  EXPECT_EQ(table.rows[0][1].text, "40.00");
  EXPECT_EQ(table.rows[3][0].text, "texram");
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(table.columns, name, &page::Table::Column::name) -
                                    table.columns.begin());
  };
  EXPECT_EQ(table.rows[0][column("cycles")].tone, page::Tone::kGood);
  EXPECT_EQ(table.rows[3][column("cycles")].tone, page::Tone::kPlain);
  EXPECT_EQ(table.rows[1][column("ns")].tone, page::Tone::kGood);
  EXPECT_EQ(table.rows[1][column("cycles")].text, "");
  EXPECT_EQ(table.rows[1][column("probes")].text, "");
  EXPECT_EQ(decibels(kPerfect), "equal");
}

TEST(report_tables, plots_of_anything) {
  const std::vector<Cell> cells{cell_of("trilinear", kPerfect, 1), cell_of("ewa", 40, 9)};
  const auto plots = standing_plots("a \"b\" 'c'", cells);
  EXPECT_EQ(plots.size(), 6U);  // none over RTL cycles, which neither has
  std::string html;
  for (const std::string& plot : plots) html += plot;
  EXPECT_EQ(html_fault(html), "");
  EXPECT_EQ(html_fault(standing_plot("none", "none", {}, kCurrencies[0], kTruthKinds[0])), "");
}

}  // namespace
}  // namespace feline
