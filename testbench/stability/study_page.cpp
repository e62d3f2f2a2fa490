// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/study_page.h"

#include <fmt/format.h>

#include <cmath>

#include "testbench/page/html.h"
#include "testbench/stability/study_data.h"
#include "testbench/stability/study_plots.h"

namespace feline::stability {
namespace {

using page::Cell;
using page::Table;
using page::Tone;

Tone tone(bool holds) { return holds ? Tone::kGood : Tone::kBad; }
Cell text(const std::string& of) { return {of}; }

std::string summary(const Study& study) {
  const std::vector<std::string> broken = study.broken();
  std::string html = page::paragraph(fmt::format(
      "Feline's footprint, level of detail and colour on stiff and extreme input, against the same algorithm "
      "at 200 bits (MPFR): {} classes of {} lookups. {}",
      study.classes.size(), study.options.count,
      broken.empty() ? fmt::format("All {} bounds on this page hold.", bound_count(study))
                     : fmt::format("{} bounds on this page are broken:", broken.size())));
  html += page::bullets(broken);
  html += page::bullets(std::vector<std::string>{
      "printed: the formulas of WRL 99/1, 2.1 and 3.1, as printed, but that atan2 gives the angle; then Feline's line "
      "of probes. In float32 and in double.",
      "stable: the same ellipse by way of hypotenuses and Kahan's determinant (model/reference/ellipse.h). In float32 "
      "and in double.",
      "unit: the bit-accurate model of the 8-bit unit in Simple and in Table mode, 16 probes, rounding of 3.1.",
      "truth: radii from the eigenvalues of M^T M and the determinant, the axis from the eigenvector of M M^T, then "
      "the same line of probes, bilinear texels and mip levels, all at 200 bits.",
  });
  return html;
}

// "holds", and for how many lookups something is promised where that is not for all.
Cell verdict_cell(const ClassResult::Row& row) {
  if (!has_bound(row)) return text("no bound");
  const bool holds = worst_share(row) <= 1;
  const Measure& level = row.measures[static_cast<std::size_t>(Metric::kLevel)];
  const std::uint64_t all = level.count + level.lost;
  const double part = static_cast<double>(level.bounded) / static_cast<double>(std::max<std::uint64_t>(all, 1));
  const std::string where = level.bounded < all ? fmt::format(" for {:.1f} %", 100 * part) : "";
  return {(holds ? "holds" : "broken") + where, tone(holds)};
}

std::string classes(const Study& study) {
  std::string html =
      page::heading(2, "Errors by class") +
      page::paragraph(
          "Worst / mean of each class. Radii relative to the true ones; the effective radius is the larger "
          "of the minor one and 2/17 of the major one, which sets the level of 16 probes. The axis in "
          "radians times 1 - (minor/major)^2: how much an error of it changes the shape, and how well the "
          "input decides it. Levels in octaves, before and after the clamps to the texture's levels; "
          "colours in codes of 1/255 of a smooth picture. \"lost\": no finite value. Verdict: against the "
          "bounds below, and for how much of the class there is one where that is not all of it. Of bound: the largest "
          "error of any quantity as a part of its own bound. Other counts: probe counts that differ from the truth's.");
  for (const ClassResult& result : study.classes) {
    html += page::heading(3, result.of->name) + page::paragraph(result.of->description);
    Table table{"", {{"subject"}, {"verdict"}, {"of bound", true}}, {}};
    for (const std::string_view name : kMetricNames) table.columns.push_back({std::string(name), true});
    table.columns.push_back({"other counts", true});
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      const ClassResult::Row& row = result.rows[s];
      std::vector<Cell> cells{text(std::string(kSubjectNames[s])), verdict_cell(row),
                              text(has_bound(row) ? fmt::format("{:.3f}", worst_share(row)) : "-")};
      for (const Measure& measure : row.measures) {
        cells.push_back({measure_text(measure), measure.holds() ? Tone::kPlain : Tone::kBad});
      }
      cells.push_back(text(fmt::format("{}", row.other_probes)));
      table.rows.push_back(std::move(cells));
    }
    html += page::table(table);
  }
  return html;
}

std::string bounds() {
  Table table{"", {{"subject"}, {"quantity"}, {"bound"}, {"why"}}, {}};
  for (const Subject subject :
       {Subject::kPrintedDouble, Subject::kStableDouble, Subject::kUnitSimple, Subject::kUnitTable}) {
    const std::string name = is_unit(subject)      ? std::string(kSubjectNames[static_cast<std::size_t>(subject)])
                             : is_printed(subject) ? "printed"
                                                   : "stable";
    for (std::size_t m = 0; m < kMetrics.size(); ++m) {
      const auto [formula, reason] = bound_text(subject, kMetrics[m]);
      if (formula.empty()) continue;
      table.rows.push_back({text(name), text(std::string(kMetricNames[m])), text(formula), text(reason)});
    }
  }
  return page::heading(2, "Bounds") +
         page::paragraph(
             "u is 2^-24 in float32 and 2^-53 in double; k is the condition number, major over minor radius. A "
             "formula's probe count may be that of the other side where fProbes is nearer to a boundary than the "
             "radii's bound: level and colour are then compared with the truth's other side. Two least denormals are "
             "forgiven, and in the unit 2^-57 texels, below which a footprint is a point. Where a radius in texels is "
             "beyond float32, or the unit says overflow, it has no error.") +
         page::table(table);
}

std::string places(double ratio) { return fmt::format("{:.6f}", ratio); }

std::string jumps(const Study& study) {
  if (study.jumps.empty()) return {};
  std::string html =
      page::heading(2, "Discontinuities") +
      page::paragraph(
          "Along each path one float32 derivative takes every value, and wherever a decision changes, the two lookups "
          "that are one ulp apart are compared. A place counts as over a step where the level jumps by more than 1/256 "
          "octave or the colour by more than 1/255. Feline itself jumps where fProbes rounds to another count: with n "
          "probes the line is widened until they cover it, by up to log2((n + 3/2)/(n + 1)) octaves, and with one more "
          "it is not. Simple and Table Feline add the longer vector and the table's cells, the number format its "
          "mantissas, which are lengths of 64 to 127 steps, and its boundaries lie elsewhere. Formulas must jump where "
          "Feline does and nowhere else.");
  Table causes{"Jumps by cause, all paths",
               {{"subject"},
                {"cause"},
                {"whose"},
                {"places", true},
                {"over a step", true},
                {"worst level, octaves", true},
                {"Feline there", true},
                {"worst colour, codes", true},
                {"worst probes", true},
                {"bound, octaves", true},
                {"worst on path"},
                {"verdict"}},
               {}};
  for (const JumpRow& row : study.jumps) {
    const bool promised = row.unpromised == 0;
    causes.rows.push_back({text(subject_name(row.subject)),
                           text(std::string(kCauseNames[static_cast<std::size_t>(row.cause)])),
                           text(std::string(origin(row.cause))),
                           text(fmt::format("{}", row.places)),
                           text(fmt::format("{}", row.over_a_step.size())),
                           text(fmt::format("{:.4f}", row.worst_level)),
                           text(fmt::format("{:.1e}", row.worst_exact_level)),
                           text(fmt::format("{:.3f}", row.worst_colour)),
                           text(fmt::format("{}", row.worst_probes)),
                           text(std::isfinite(row.bound)        ? fmt::format("{:.4f}", row.bound)
                                : row.cause == Cause::kRounding ? "none"
                                                                : "where Feline has it"),
                           text(std::string(row.worst.path)),
                           {!row.holds ? "broken"
                            : promised ? "holds"
                                       : "no bound",
                            !row.holds ? Tone::kBad
                            : promised ? Tone::kGood
                                       : Tone::kPlain}});
  }
  html += page::table(causes);
  html += page::paragraph(
      fmt::format("In Table mode the ratio of the radii is the cell's, so that probe counts change with cells. Every "
                  "place over a step is in stability-jumps.csv. The unit's bounds: Table {:.3f}, Simple {:.3f} "
                  "octaves, the most by which stored radii can be off against each other, times a line widened by 5/4, "
                  "and 0.0224 for roundings.",
                  unit_jump_bound(true), unit_jump_bound(false)));
  Table steps{"One probe more: 2 major/minor where it comes, and the level's jump there",
              {{"probes"}, {"Feline", true}, {"octaves", true}},
              {}};
  for (const std::string_view name : kSubjectNames) {
    steps.columns.push_back({std::string(name), true});
    steps.columns.push_back({"octaves", true});
  }
  for (const ProbeStep& step : study.probe_steps) {
    std::vector<Cell> cells{text(fmt::format("{} to {}", step.probes, step.probes + 1))};
    const auto add = [&](const std::optional<double>& place, const std::optional<double>& level) {
      cells.push_back(text(place ? places(*place) : "-"));
      cells.push_back(text(level ? fmt::format("{:.4f}", *level) : "-"));
    };
    add(step.ideal_place, step.ideal_level);
    for (std::size_t s = 0; s < kSubjects.size(); ++s) add(step.place[s], step.level[s]);
    steps.rows.push_back(std::move(cells));
  }
  html += page::table(steps);
  std::vector<std::string> walked;
  for (const Path& path : study.paths) {
    const std::string line = fmt::format("{}: {}", path.name, path.description);
    if (walked.empty() || walked.back() != line) walked.push_back(line);
  }
  return html + page::heading(3, "The paths") + page::bullets(walked);
}

std::string non_finite(const Study& study) {
  if (study.non_finite.empty()) return {};
  Table table{"", {{"input"}, {"lookups", true}}, {}};
  for (const std::string_view name : kSubjectNames) table.columns.push_back({std::string(name), true});
  for (const NonFiniteRow& row : study.non_finite) {
    std::vector<Cell> cells{text(std::string(row.what)), text(fmt::format("{}", row.count))};
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      const NonFiniteRow::Result& result = row.results[s];
      std::string said = fmt::format("{} / {} / {}", result.colour_defined, result.level_defined, result.coarsest);
      if (is_unit(kSubjects[s])) said += fmt::format(" / {}", result.flagged);
      cells.push_back({said, is_unit(kSubjects[s]) ? tone(row.holds(kSubjects[s])) : Tone::kPlain});
    }
    table.rows.push_back(std::move(cells));
  }
  return page::heading(2, "NaN, infinity and the ends of float32") +
         page::paragraph(
             "Each value in each operand of its kind, in each pair with opposite signs, and in all. Lookups with a "
             "colour within the texture's range / with a level within its levels / with the coarsest level; of the "
             "unit also those whose status bits are what its contract says. The unit must have a colour, a level and "
             "the right status every time. The formulas promise nothing for input that is not finite: the printed ones "
             "pass NaN on, the stable ones take NaN for a footprint of no size, which is the finest level; the unit "
             "takes it for one without bound, which is the coarsest.") +
         page::table(table);
}

}  // namespace

std::string to_html(const Study& study) {
  return page::document(
      "Feline: stability on stiff and extreme input",
      summary(study) + page::gallery(plots(study)) + classes(study) + jumps(study) + non_finite(study) + bounds());
}

}  // namespace feline::stability
