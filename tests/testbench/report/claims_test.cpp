// SPDX-License-Identifier: Apache-2.0
// Each claim just within and just beyond its limit.
#include "testbench/report/claims.h"

#include <gtest/gtest.h>

#include <limits>

#include "testbench/report/report.h"
#include "tests/testbench/report/surveys.h"

namespace feline {
namespace {

constexpr double kLittle = 0.001;

Claim claim_of(std::string_view name, const Survey& survey) {
  for (Claim& claim : judge_claims(survey)) {
    if (claim.name == name) return claim;
  }
  ADD_FAILURE() << "no claim " << name;
  return {};
}

Verdict verdict(std::string_view name, const std::string& exhibit, const std::vector<Cell>& cells) {
  return claim_of(name, survey_of({result_of(exhibit, cells)})).verdict;
}

TEST(report_claims, nothing_measured) {
  for (const Survey& survey : {Survey{}, survey_of({result_of("bricks", {cell_of("nearest", 20)})})}) {
    const auto claims = judge_claims(survey);
    EXPECT_EQ(claims.size(), 9U);
    for (const Claim& claim : claims) {
      EXPECT_EQ(claim.verdict, Verdict::kNotMeasured) << claim.name;
      EXPECT_TRUE(claim.measured.empty());
      EXPECT_FALSE(claim.source.empty());
    }
  }
}

TEST(report_claims, eight_bits_suffice) {
  for (const std::string suffix : {"", "_gaussian"}) {
    const auto with = [&](double behind) {
      return verdict("8 bits suffice", "any",
                     {cell_of("feline_table" + suffix, 30), cell_of("unit_table" + suffix, 30 - behind)});
    };
    EXPECT_EQ(with(kUnitBound - kLittle), Verdict::kHolds);
    EXPECT_EQ(with(kUnitBound + kLittle), Verdict::kContradicted);
    EXPECT_EQ(with(-9), Verdict::kHolds);
  }
}

// Each truth counts: cell_of's is the same against both.
TEST(report_claims, eight_bits_suffice_against_either_truth) {
  for (CellErrors Cell::*const truth : {&Cell::gaussian, &Cell::box}) {
    std::vector<Cell> cells{cell_of("feline_table", 30), cell_of("unit_table", 30)};
    (cells[1].*truth).errors.mean_square = mean_square_of(29);
    EXPECT_EQ(verdict("8 bits suffice", "any", cells), Verdict::kContradicted);
  }
}

// Two kernels of a scene are one scene, and one that is too small is not judged.
TEST(report_claims, eight_bits_are_judged_by_the_scene) {
  const std::vector<Cell> cells{cell_of("feline_table", 30), cell_of("unit_table", 30),
                                cell_of("feline_table_gaussian", 30), cell_of("unit_table_gaussian", 30)};
  ExhibitResult small = result_of("spin", cells);
  small.plan.width = kLeastJudgedSide / 2;
  EXPECT_EQ(verdict_text(claim_of("8 bits suffice", survey_of({result_of("bricks", cells), small}))),
            "holds, 1 of 2 scenes");
  EXPECT_EQ(verdict_text(claim_of("8 bits suffice", survey_of({result_of("bricks", cells)}))), "holds");
}

// Bounds of this project fail the report; a paper's sentence does not.
TEST(report_claims, only_ours_break_the_report) {
  const auto report_of = [](double unit, double simple) {
    return make_report(survey_of({result_of(
        "window", {cell_of("feline_table", 30), cell_of("unit_table", unit), cell_of("feline_simple", simple)})}));
  };
  EXPECT_TRUE(report_of(30, 26).holds);
  EXPECT_TRUE(report_of(30, 26).json["holds"]);
  const Report papers = report_of(30, 29);
  EXPECT_TRUE(papers.holds);
  EXPECT_NE(papers.text.find("contradicted"), std::string::npos);
  const Report broken = report_of(29, 26);
  EXPECT_FALSE(broken.holds);
  EXPECT_FALSE(broken.json["holds"]);
}

// One exhibit that contradicts is enough, wherever it stands.
TEST(report_claims, one_exhibit_contradicts) {
  const auto exhibit = [](const char* name, double unit) {
    return result_of(name, {cell_of("feline_table", 30), cell_of("unit_table", unit)});
  };
  for (const auto& units : {std::array{28.0, 30.0, 30.0}, std::array{30.0, 28.0, 30.0}, std::array{30.0, 30.0, 28.0}}) {
    const Claim claim =
        claim_of("8 bits suffice",
                 survey_of({exhibit("bricks", units[0]), exhibit("text", units[1]), exhibit("own", units[2])}));
    EXPECT_EQ(claim.verdict, Verdict::kContradicted);
    EXPECT_EQ(claim.measured.size(), 3U);
    EXPECT_TRUE(claim.ours);
  }
}

TEST(report_claims, fewer_probes) {
  const auto with = [](double fewer, const char* exhibit = "bricks") {
    return verdict("high quality takes 24 % fewer probes", exhibit,
                   {cell_of("feline_simple", 30, 4), cell_of("feline_simple_high_quality", 30, 4 * (1 - fewer))});
  };
  EXPECT_EQ(with(0.24), Verdict::kHolds);
  EXPECT_EQ(with(0.20 + kLittle), Verdict::kHolds);
  EXPECT_EQ(with(0.28 - kLittle), Verdict::kHolds);
  EXPECT_EQ(with(0.20 - kLittle), Verdict::kContradicted);
  EXPECT_EQ(with(0.28 + kLittle), Verdict::kContradicted);
  EXPECT_EQ(with(0.24, "window"), Verdict::kNotMeasured);
}

TEST(report_claims, as_many_probes_as_texram) {
  const auto with = [](double ratio) {
    return verdict("high efficiency takes as many probes as Texram", "runway",
                   {cell_of("texram", 30, 3), cell_of("feline_simple_high_efficiency", 30, 3 * ratio)});
  };
  EXPECT_EQ(with(1.1 - kLittle), Verdict::kHolds);
  EXPECT_EQ(with(0.9 + kLittle), Verdict::kHolds);
  EXPECT_EQ(with(1.1 + kLittle), Verdict::kContradicted);
  EXPECT_EQ(with(0.9 - kLittle), Verdict::kContradicted);
}

// Over all exhibits together, not over each.
TEST(report_claims, probes_are_added_up) {
  const auto exhibit = [](const char* name, double texram, double feline) {
    return result_of(name, {cell_of("texram", 30, texram), cell_of("feline_simple_high_efficiency", 31, feline)});
  };
  const Claim claim = claim_of("high efficiency takes as many probes as Texram",
                               survey_of({exhibit("bricks", 2, 4), exhibit("text", 9, 7)}));
  EXPECT_EQ(claim.verdict, Verdict::kHolds);
  EXPECT_EQ(claim.measured.size(), 3U);
}

TEST(report_claims, better_than_texram) {
  const auto with = [](double ahead) {
    return verdict("high efficiency is better than Texram", "curves",
                   {cell_of("texram", 30), cell_of("feline_simple_high_efficiency", 30 + ahead)});
  };
  EXPECT_EQ(with(kLittle), Verdict::kHolds);
  EXPECT_EQ(with(-kLittle), Verdict::kContradicted);
}

TEST(report_claims, table_against_simple) {
  const auto with = [](const char* name, const char* exhibit, double ahead) {
    return verdict(name, exhibit, {cell_of("feline_simple", 30), cell_of("feline_table", 30 + ahead)});
  };
  const char* const extreme = "Table beats Simple on extreme projections";
  EXPECT_EQ(with(extreme, "sphere", 3 + kLittle), Verdict::kHolds);
  EXPECT_EQ(with(extreme, "sphere", 3 - kLittle), Verdict::kContradicted);
  EXPECT_EQ(with(extreme, "bricks", 3 - kLittle), Verdict::kNotMeasured);
  const char* const ordinary = "Table equals Simple on ordinary perspective";
  EXPECT_EQ(with(ordinary, "bricks", 0.3 - kLittle), Verdict::kHolds);
  EXPECT_EQ(with(ordinary, "bricks", -0.3 + kLittle), Verdict::kHolds);
  EXPECT_EQ(with(ordinary, "bricks", 0.3 + kLittle), Verdict::kContradicted);
  EXPECT_EQ(with(ordinary, "bricks", -0.3 - kLittle), Verdict::kContradicted);
  EXPECT_EQ(with(ordinary, "sphere", 1), Verdict::kNotMeasured);
}

TEST(report_claims, comparable_to_ewa) {
  const auto with = [](double behind) {
    return verdict("Feline is comparable to EWA", "text", {cell_of("ewa", 30), cell_of("feline_ideal", 30 - behind)});
  };
  EXPECT_EQ(with(1 - kLittle), Verdict::kHolds);
  EXPECT_EQ(with(-3), Verdict::kHolds);
  EXPECT_EQ(with(1 + kLittle), Verdict::kContradicted);
}

// What circles of texels gain is a mean over all scenes that have them, also those where they lose.
TEST(report_claims, what_the_probes_are_of_the_distance_to_ewa) {
  const auto exhibit = [](const char* name, double feline, double circles) {
    return result_of(name,
                     {cell_of("ewa", 40), cell_of("feline_ideal", feline), cell_of("feline_ideal_circles", circles)});
  };
  const Claim claim =
      claim_of("Feline is comparable to EWA",
               survey_of({exhibit("text", 30, 36), exhibit("bricks", 36, 35), exhibit("curves", 34, 35)}));
  EXPECT_NE(claim.reason.find("gain +2.0 dB of the 6.7 that Feline is behind, on the mean of 3 scenes"),
            std::string::npos)
      << claim.reason;
}

// Small pictures are not judged, and errors that 8 bits do not show are none.
TEST(report_claims, what_is_not_judged) {
  const auto with = [](int side, double real, double unit) {
    ExhibitResult result = result_of("own", {cell_of("feline_table", real), cell_of("unit_table", unit)});
    result.plan.width = result.plan.height = side;
    return claim_of("8 bits suffice", survey_of({result})).verdict;
  };
  EXPECT_EQ(with(kLeastJudgedSide, 30, 28), Verdict::kContradicted);
  EXPECT_EQ(with(kLeastJudgedSide - 1, 30, 28), Verdict::kNotMeasured);
  // 1 / (255 sqrt(12)) is 58.92 dB.
  EXPECT_EQ(with(kLeastJudgedSide, 70, 59), Verdict::kHolds);
  EXPECT_EQ(with(kLeastJudgedSide, 70, 58.9), Verdict::kContradicted);
}

// A user's own file may have a scene's name; a paper's sentence is of more scenes than one.
TEST(report_claims, scenes_are_told_apart_and_counted) {
  const std::vector<Cell> cells{cell_of("feline_simple", 30), cell_of("feline_table", 34)};
  ExhibitResult own = result_of("window", cells);
  own.plan.perspective = false;
  const std::string_view name = "Table beats Simple on extreme projections";
  EXPECT_EQ(claim_of(name, survey_of({own})).verdict, Verdict::kNotMeasured);
  EXPECT_EQ(verdict_text(claim_of(name, survey_of({result_of("window", cells)}))), "holds, 1 of 3 scenes");
  EXPECT_EQ(verdict_text(claim_of(name, survey_of({result_of("window", cells), result_of("sphere", cells),
                                                   result_of("reflector", cells)}))),
            "holds");
}

// A picture without any error has no finite PSNR.
TEST(report_claims, pictures_without_error) {
  const double perfect = std::numeric_limits<double>::infinity();
  const auto with = [&](double real, double unit) {
    return claim_of("8 bits suffice",
                    survey_of({result_of("own", {cell_of("feline_table", real), cell_of("unit_table", unit)})}));
  };
  EXPECT_EQ(with(perfect, perfect).verdict, Verdict::kHolds);
  EXPECT_EQ(with(perfect, 30).verdict, Verdict::kContradicted);
  EXPECT_EQ(with(perfect, perfect).measured.front().find("nan"), std::string::npos)
      << with(perfect, perfect).measured.front();
}

}  // namespace
}  // namespace feline
