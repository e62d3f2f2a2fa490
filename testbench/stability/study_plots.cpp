// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/study_plots.h"

#include <algorithm>
#include <cmath>

#include "testbench/page/html.h"
#include "testbench/page/plot.h"
#include "testbench/stability/study_data.h"

namespace feline::stability {
namespace {

using page::Axis;
using page::Plot;
using page::Series;
using page::Style;

// Below it lies what has no error at all: logarithms have no 0.
constexpr double kFloor = 1e-18;

Plot by_condition(const Study& study, const std::string& name, const std::string& title,
                  decltype(Decade::major) Decade::*errors, bool units) {
  Plot plot{name, title, {"condition number", true, 1, 1e13}, {"worst relative error", true, 1e-17, 10}};
  for (std::size_t s = 0; s < kSubjects.size(); ++s) {
    if (is_unit(kSubjects[s]) && !units) continue;
    Series series{std::string(kSubjectNames[s])};
    for (const auto& [decade, row] : study.decades) {
      const std::optional<double>& error = (row.*errors)[s];
      // All digits lost is all there is to lose.
      if (error) series.points.push_back({std::pow(10.0, decade + 0.5), std::clamp(*error, kFloor, 1.0)});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

// Classes from top to bottom.
Plot by_class(const Study& study, const std::string& name, const std::string& title, const std::string& unit,
              Metric metric) {
  Plot plot{name, title, {unit, true, kFloor / 10, 1000}, {}};
  const std::size_t count = study.classes.size();
  for (std::size_t c = count; c-- > 0;) plot.y.names.emplace_back(study.classes[c].of->name);
  for (std::size_t s = 0; s < kSubjects.size(); ++s) {
    Series series{std::string(kSubjectNames[s]), {}, Style::kPoints};
    for (std::size_t c = 0; c < count; ++c) {
      const Measure& measure = study.classes[c].rows[s].measures[static_cast<std::size_t>(metric)];
      if (measure.count == 0) continue;
      series.points.push_back({std::max(measure.worst, kFloor), static_cast<double>(count - 1 - c)});
    }
    plot.series.push_back(std::move(series));
  }
  plot.height = 240 + 22 * static_cast<int>(count);
  return plot;
}

Plot probe_steps(const Study& study) {
  Plot plot{"probe-steps", "One probe more: the level's fall", {"2 major / minor radius"}, {"octaves"}};
  const auto add = [&](const std::string& name, const auto& place_of, const auto& level_of) {
    Series series{name};
    for (const ProbeStep& step : study.probe_steps) {
      if (place_of(step) && level_of(step)) series.points.push_back({*place_of(step), -*level_of(step)});
    }
    plot.series.push_back(std::move(series));
  };
  add(
      subject_name({}), [](const ProbeStep& s) { return s.ideal_place; },
      [](const ProbeStep& s) { return s.ideal_level; });
  for (const Subject subject : {Subject::kUnitSimple, Subject::kUnitTable}) {
    const auto s = static_cast<std::size_t>(subject);
    add(
        std::string(kSubjectNames[s]), [s](const ProbeStep& step) { return step.place[s]; },
        [s](const ProbeStep& step) { return step.level[s]; });
  }
  return plot;
}

Plot causes(const Study& study) {
  Plot plot{"causes", "Largest jump over one ulp, by cause", {}, {"octaves"}};
  std::vector<Cause> shown;
  for (std::size_t c = 0; c < kCauseNames.size(); ++c) {
    const auto has = [&](const JumpRow& row) {
      return static_cast<std::size_t>(row.cause) == c && (!row.subject || is_unit(*row.subject));
    };
    if (std::ranges::none_of(study.jumps, has)) continue;
    shown.push_back(static_cast<Cause>(c));
    plot.x.names.emplace_back(kCauseNames[c]);
  }
  for (const std::optional<Subject> subject :
       {std::optional<Subject>(), std::optional(Subject::kUnitSimple), std::optional(Subject::kUnitTable)}) {
    Series series{subject_name(subject), {}, Style::kBars};
    for (const JumpRow& row : study.jumps) {
      const auto at = std::ranges::find(shown, row.cause);
      if (row.subject != subject || at == shown.end()) continue;
      series.points.push_back({static_cast<double>(at - shown.begin()), row.worst_level});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::vector<std::string> plots(const Study& study) {
  std::vector<std::string> all;
  const auto add = [&](const Plot& plot, const std::string& caption) {
    all.push_back(page::figure(page::svg(plot), caption));
  };
  if (!study.decades.empty()) {
    add(by_condition(study, "minor", "Minor radius", &Decade::minor, false),
        "The printed formulas lose digits with the square of the condition number and have none left at 1e4 in float32 "
        "and 1e8 in double; the stable ones lose none. Worst of each decade, all classes between 2^-24 and 2^24 texels "
        "whose size is a power of two; 1 is all digits.");
    add(by_condition(study, "major", "Major radius", &Decade::major, true),
        "The printed formulas lose the major radius as well: it comes from a difference of two large numbers. The unit "
        "does not depend on the condition number.");
    add(by_condition(study, "effective", "Effective radius, max(minor, 2/17 major)", &Decade::effective, true),
        "What sets the level of detail. Simple Feline takes the shortest side or diagonal for the minor radius, up to "
        "3.96 times the effective one, so its error is shown as 1 there.");
  }
  if (!study.classes.empty()) {
    add(by_class(study, "level", "Level of detail, worst of each class", "octaves", Metric::kLevel),
        "Within the texture's levels. At the left end: no error at all. Missing: no finite value.");
    add(by_class(study, "colour", "Colour, worst of each class", "codes, 1/255", Metric::kColour),
        "A smooth picture. Far from the origin float32 loses colour that the unit's fixed point keeps.");
  }
  if (!study.probe_steps.empty()) {
    add(probe_steps(study),
        "A probe more lets the level fall in Feline itself. Simple takes its steps where the 8-bit mantissas allow, "
        "Table where its cells end, several counts at once.");
  }
  if (!study.jumps.empty()) {
    add(causes(study), "The unit's largest jumps are those of the table's cells, which bring other probe counts.");
  }
  return all;
}

}  // namespace feline::stability
