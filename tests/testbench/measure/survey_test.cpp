// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/survey.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/testbench/measure/surfaces.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

constexpr int kSurveySide = 32;
constexpr int kSurveyStrata = 4;

SurveyOptions options_of(const std::vector<std::string>& scenes, const std::vector<std::string>& filters) {
  SurveyOptions options;
  for (const std::string& name : scenes)
    options.exhibits.push_back(plan_exhibit(small_scene(name), kSurveySide, kSurveySide));
  for (const std::string& name : filters) options.contestants.push_back(find_contestant(name));
  options.strata = kSurveyStrata;
  return options;
}

// Counts how often an exhibit is built: never, when all of it is in the cache.
void count_builds(SurveyOptions& options, int& builds) {
  for (ExhibitPlan& plan : options.exhibits) {
    plan.build = [&builds, build = plan.build] {
      ++builds;
      return build();
    };
  }
}

// All that a survey measured, as text; times too, if wanted.
std::string told(const Survey& survey, bool times) {
  nlohmann::ordered_json all;
  for (const ExhibitResult& result : survey.results) {
    const TruthFacts& truth = result.truth.value();
    all.push_back({truth.gaussian_error, truth.box_error, truth.samples, truth.focus.detail.left,
                   truth.focus.detail.top, truth.focus.quarter.size, truth.overview_png, truth.gaussian_png,
                   truth.box_png});
    for (const Cell& cell : result.cells) {
      auto json = to_json(cell);
      if (!times) json.erase("nanoseconds");
      all.push_back(std::move(json));
    }
    for (const Split& split : result.splits) {
      all.push_back({split.kernel, split.feline, split.table, split.arithmetic});
    }
  }
  return all.dump();
}

TEST(measure_survey, goes_on_from_its_cache) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  SurveyOptions options = options_of({"bricks", "spin"}, {"trilinear", "unit_table"});
  int builds = 0;
  count_builds(options, builds);
  const Survey first = run_survey(options, cache);
  EXPECT_EQ(builds, 2);
  EXPECT_EQ(first.missing, 0U);
  ASSERT_EQ(first.results.size(), 2U);
  for (const ExhibitResult& result : first.results) {
    ASSERT_EQ(result.cells.size(), 2U);
    EXPECT_EQ(result.cells[1].contestant, "unit_table");
    EXPECT_TRUE(result.cells[1].rtl_cycles);
    EXPECT_FALSE(result.cells[0].rtl_cycles);
    EXPECT_EQ(result.splits.size(), 2U);
    EXPECT_EQ(result.truth->samples, 2 * kSurveyStrata * kSurveyStrata);
    // A sequence shimmers, a still cannot.
    for (const Cell& cell : result.cells) {
      EXPECT_EQ(cell.gaussian.shimmer.has_value(), result.plan.name == "spin");
      EXPECT_EQ(cell.box.shimmer.has_value(), result.plan.name == "spin");
      EXPECT_GE(cell.gaussian.shimmer.value_or(1), 1e-9);
    }
  }
  // The times are those of the first run.
  EXPECT_EQ(told(run_survey(options, cache), true), told(first, true));
  EXPECT_EQ(builds, 2);

  // What was damaged is made again, and no more of it.
  for (const auto& entry : std::filesystem::directory_iterator(dir / "cache")) {
    std::string bytes = read_bytes(entry.path());
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    write_bytes(entry.path(), bytes);
  }
  EXPECT_EQ(told(run_survey(options, cache), false), told(first, false));
  EXPECT_EQ(builds, 4);
  run_survey(options, cache);
  EXPECT_EQ(builds, 4);
}

TEST(measure_survey, only_what_is_new_is_measured) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  const Survey one = run_survey(options_of({"bricks"}, {"trilinear"}), cache);
  const Survey two = run_survey(options_of({"bricks"}, {"nearest", "trilinear"}), cache);
  EXPECT_EQ(to_json(two.results[0].cells[1]), to_json(one.results[0].cells[0]));
  // Others samples, other errors.
  SurveyOptions other = options_of({"bricks"}, {"trilinear"});
  other.seed = 2;
  EXPECT_NE(run_survey(other, cache).results[0].cells[0].gaussian.errors.mean_square,
            one.results[0].cells[0].gaussian.errors.mean_square);
  other.seed = 1;
  other.strata = kSurveyStrata + 1;
  EXPECT_NE(run_survey(other, cache).results[0].truth->samples, one.results[0].truth->samples);
}

TEST(measure_survey, a_budget_of_nothing) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  SurveyOptions options = options_of({"bricks", "spin"}, {"trilinear", "unit_table", "ewa"});
  options.budget = 0;
  int builds = 0;
  count_builds(options, builds);
  const Survey survey = run_survey(options, cache);
  // A truth, three cells and two splits of each.
  EXPECT_EQ(survey.missing, 12U);
  EXPECT_EQ(builds, 0);
  ASSERT_EQ(survey.results.size(), 2U);
  for (const ExhibitResult& result : survey.results) {
    EXPECT_FALSE(result.truth);
    EXPECT_TRUE(result.cells.empty());
    EXPECT_TRUE(result.splits.empty());
  }
  EXPECT_TRUE(std::filesystem::is_empty(dir / "cache"));
}

// What is known already costs nothing.
TEST(measure_survey, a_budget_of_nothing_for_what_is_known) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  SurveyOptions options = options_of({"bricks"}, {"trilinear"});
  const Survey whole = run_survey(options, cache);
  options.budget = 0;
  const Survey again = run_survey(options, cache);
  EXPECT_EQ(again.missing, 0U);
  EXPECT_EQ(told(again, true), told(whole, true));
  SurveyOptions more = options_of({"bricks"}, {"nearest", "trilinear"});
  more.budget = 0;
  const Survey partly = run_survey(more, cache);
  EXPECT_EQ(partly.missing, 1U);
  ASSERT_EQ(partly.results[0].cells.size(), 1U);
  EXPECT_EQ(partly.results[0].cells[0].contestant, "trilinear");
}

// The truth's own error is that of the channels that the texture has.
TEST(measure_survey, one_channel_has_its_own_error) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  for (const char* const name : {"text", "bricks"}) {
    const ExhibitPlan plan = plan_exhibit(small_scene(name), kSurveySide, kSurveySide);
    const Exhibit exhibit = plan.build();
    const Truth truth = compute_truth(exhibit.frames[0], kSurveyStrata, 1, nullptr);
    const double share = exhibit.channels() == 1 ? std::sqrt(3) : 1;
    const TruthFacts facts = run_survey(options_of({name}, {}), cache).results[0].truth.value();
    EXPECT_NEAR(facts.gaussian_error, share * truth.gaussian_error, 1e-12) << name;
    EXPECT_NEAR(facts.box_error, share * truth.box_error, 1e-12) << name;
    EXPECT_EQ(facts.focus.detail.size, kSurveySide);
    EXPECT_EQ(facts.focus.quarter.size, kSurveySide / 2);
  }
}

TEST(measure_survey, the_parts_of_the_units_error) {
  const TempDir dir;
  const Cache cache(dir / "cache");
  const Survey survey = run_survey(options_of({"bricks"}, {"feline_ideal", "feline_table_gaussian"}), cache);
  const ExhibitResult& result = survey.results[0];
  ASSERT_EQ(result.splits.size(), 2U);
  EXPECT_EQ(result.splits[0].kernel, "bilinear");
  EXPECT_DOUBLE_EQ(result.splits[0].feline, result.cells[0].gaussian.errors.mean_square);
  const Exhibit exhibit = result.plan.build();
  const auto picture = [&](const char* name) {
    return find_contestant(name)->render(exhibit.frames[0], nullptr).picture;
  };
  const FloatPicture table = picture("feline_table_gaussian");
  EXPECT_DOUBLE_EQ(result.splits[1].table, compare(table, picture("feline_ideal_gaussian"), 3).mean_square);
  EXPECT_DOUBLE_EQ(result.splits[1].arithmetic, compare(picture("unit_table_gaussian"), table, 3).mean_square);
}

}  // namespace
}  // namespace feline
