// SPDX-License-Identifier: Apache-2.0
#include "testbench/report/standing.h"

#include <gtest/gtest.h>

#include "tests/testbench/report/surveys.h"

namespace feline {
namespace {

const Currency& currency(std::string_view name) { return *std::ranges::find(kCurrencies, name, &Currency::name); }

std::vector<std::string> front_of(const std::vector<Cell>& cells, std::string_view name, std::size_t truth = 0) {
  std::vector<std::string> names;
  for (const Cell* const cell : pareto_front(cells, currency(name), kTruthKinds[truth])) {
    names.push_back(cell->contestant);
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(report_standing, one_or_none) {
  EXPECT_EQ(front_of({}, "cycles"), Names{});
  EXPECT_EQ(front_of({cell_of("ewa", 30, 5)}, "cycles"), Names{"ewa"});
}

TEST(report_standing, what_is_beaten_is_not_on_the_front) {
  const std::vector<Cell> cells{cell_of("ewa", 40, 8), cell_of("trilinear", 25, 1), cell_of("texram", 24, 4),
                                cell_of("feline_simple", 35, 5), cell_of("ext", 35.1, 4.9)};
  EXPECT_EQ(front_of(cells, "cycles"), (Names{"trilinear", "ext", "ewa"}));
}

TEST(report_standing, ties) {
  // As cheap and worse; as good and dearer; the same.
  EXPECT_EQ(front_of({cell_of("ext", 30, 2), cell_of("texram", 31, 2)}, "cycles"), Names{"texram"});
  EXPECT_EQ(front_of({cell_of("ext", 30, 3), cell_of("texram", 30, 2)}, "cycles"), Names{"texram"});
  EXPECT_EQ(front_of({cell_of("ext", 30, 2), cell_of("texram", 30, 2)}, "cycles"), (Names{"ext", "texram"}));
}

TEST(report_standing, each_truth_has_its_own_front) {
  std::vector<Cell> cells{cell_of("texram", 30, 2), cell_of("ewa", 35, 2)};
  cells[0].box.errors.mean_square = mean_square_of(40);
  EXPECT_EQ(front_of(cells, "cycles", 0), Names{"ewa"});
  EXPECT_EQ(front_of(cells, "cycles", 1), Names{"texram"});
}

// The model's time is not the hardware's, and a library tells no texels.
TEST(report_standing, each_currency_counts_whom_it_can) {
  const std::vector<Cell> cells{cell_of("unit_table", 40, 1), cell_of("openimageio", 41, 1), cell_of("ewa", 30, 2)};
  EXPECT_EQ(front_of(cells, "nanoseconds"), Names{"openimageio"});
  EXPECT_EQ(front_of(cells, "cycles"), Names{"unit_table"});
  EXPECT_EQ(front_of(cells, "texels"), Names{"unit_table"});
  EXPECT_EQ(front_of(cells, "rtl_cycles"), Names{});
  std::vector<Cell> with_rtl = cells;
  with_rtl[0].rtl_cycles = 7;
  EXPECT_EQ(front_of(with_rtl, "rtl_cycles"), Names{"unit_table"});
}

TEST(report_standing, where_the_worst_pixel_is) {
  ExhibitPlan plan;
  CellErrors errors;
  errors.errors.worst_column = 3;
  errors.errors.worst_row = 14;
  errors.worst_frame = 5;
  EXPECT_EQ(worst_pixel(plan, errors), "(3, 14)");
  plan.frame_count = 8;
  EXPECT_EQ(worst_pixel(plan, errors), "(3, 14) of frame 5");
}

TEST(report_standing, a_front_holds_its_own_cells) {
  const std::vector<Cell> cells{cell_of("ewa", 40, 8), cell_of("trilinear", 25, 1), cell_of("texram", 24, 4)};
  const auto front = pareto_front(cells, currency("texels"), kTruthKinds[0]);
  EXPECT_TRUE(on_front(front, cells[0]));
  EXPECT_TRUE(on_front(front, cells[1]));
  EXPECT_FALSE(on_front(front, cells[2]));
}

TEST(report_standing, pooled_over_exhibits) {
  Cell a = cell_of("ewa", 30, 2);
  Cell b = cell_of("ewa", 20, 6);
  a.gaussian.errors.worst = 0.25;
  b.gaussian.errors.worst = 0.75;
  a.box.errors.mean_square = 0.5;
  b.box.errors.mean_square = 0.25;
  a.gaussian.butteraugli = 0.5;
  b.gaussian.butteraugli = 0.25;
  Cell unit_a = cell_of("unit_table", 30);
  Cell unit_b = cell_of("unit_table", 30);
  unit_a.rtl_cycles = 10;
  unit_b.rtl_cycles = 30;
  const Survey survey = survey_of(
      {result_of("first", {cell_of("texram", 50), a, unit_a}), result_of("second", {unit_b, b, cell_of("ext", 50)})});
  const std::vector<Cell> pooled = pool_exhibits(survey);
  // What was measured on one of the two only is not there.
  ASSERT_EQ(pooled.size(), 2U);
  const Cell& all = pooled[0];
  EXPECT_EQ(all.contestant, "ewa");
  EXPECT_EQ(all.exhibit, "all");
  EXPECT_DOUBLE_EQ(all.gaussian.errors.mean_square, (0.001 + 0.01) / 2);
  EXPECT_DOUBLE_EQ(all.box.errors.mean_square, 0.375);
  EXPECT_DOUBLE_EQ(all.gaussian.errors.worst, 0.75);
  EXPECT_DOUBLE_EQ(all.gaussian.butteraugli, 0.375);
  EXPECT_DOUBLE_EQ(all.nanoseconds, 400);
  EXPECT_DOUBLE_EQ(all.cost.probes, 4);
  EXPECT_DOUBLE_EQ(all.cost.texels, 32);
  EXPECT_FALSE(all.rtl_cycles);
  EXPECT_DOUBLE_EQ(pooled[1].rtl_cycles.value(), 20);
}

TEST(report_standing, pooled_over_nothing) {
  EXPECT_TRUE(pool_exhibits({}).empty());
  EXPECT_TRUE(pool_exhibits(survey_of({result_of("first", {}), result_of("second", {cell_of("ewa", 1)})})).empty());
}

TEST(report_standing, cells_by_name) {
  const ExhibitResult result = result_of("first", {cell_of("ewa", 30), cell_of("ext", 20)});
  EXPECT_EQ(find_cell(result, "ext"), &result.cells[1]);
  EXPECT_EQ(find_cell(result, "texram"), nullptr);
}

}  // namespace
}  // namespace feline
