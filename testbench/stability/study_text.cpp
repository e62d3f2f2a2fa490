// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "testbench/stability/study_data.h"

namespace feline::stability {

std::string to_csv(const Study& study) {
  std::string text =
      "class,subject,metric,unit,count,lost,worst,mean,bounded,worst_share_of_bound,verdict,size,s,t,dsdx,dtdx,dsdy,"
      "dtdy\n";
  for (const ClassResult& result : study.classes) {
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      for (std::size_t m = 0; m < kMetrics.size(); ++m) {
        const Measure& of = result.rows[s].measures[m];
        text += fmt::format("{},{},\"{}\",\"{}\",{},{},", result.of->name, kSubjectNames[s], kMetricNames[m],
                            kMetricUnits[m], of.count, of.lost);
        text += of.count == 0 ? std::string(",,") : fmt::format("{:.6g},{:.6g},", of.worst, of.mean());
        text += fmt::format("{},", of.bounded);
        text += of.bounded == 0 ? std::string(",no bound")
                                : fmt::format("{:.6g},{}", of.worst_share, of.holds() ? "holds" : "broken");
        const Lookup& at = of.worst_case.lookup;
        text += of.count + of.lost == 0
                    ? std::string(",,,,,,,\n")
                    : fmt::format(",{}x{},{},{},{},{},{},{}\n", texture_of(of.worst_case).width(),
                                  texture_of(of.worst_case).height(), at.s, at.t, at.dsdx, at.dtdx, at.dsdy, at.dtdy);
      }
    }
  }
  return text;
}

std::string jumps_to_csv(const Study& study) {
  std::string text =
      "subject,cause,whose,path,derivative_before,derivative_after,probes_before,probes_after,level,colour,"
      "level_of_feline,s,t,dsdx,dtdx,dsdy,dtdy\n";
  for (const JumpRow& row : study.jumps) {
    for (const Jump& jump : row.over_a_step) {
      const Lookup& at = jump.at.lookup;
      text += fmt::format("{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{},{},{},{},{},{}\n", subject_name(row.subject),
                          kCauseNames[static_cast<std::size_t>(row.cause)], origin(row.cause), jump.path, jump.before,
                          jump.after, jump.probes_before, jump.probes_after, jump.level, jump.colour, jump.exact_level,
                          at.s, at.t, at.dsdx, at.dtdx, at.dsdy, at.dtdy);
    }
  }
  return text;
}

std::string to_text(const Study& study) {
  std::string text =
      fmt::format("Forward errors against Feline at 200 bits, {} lookups a class: worst / mean\n", study.options.count);
  for (const ClassResult& result : study.classes) {
    text += fmt::format("\n{}: {}\n{:<16}", result.of->name, result.of->description, "");
    for (const std::string_view name : {"major radius", "effective radius", "axis", "level", "colour"}) {
      text += fmt::format("{:>19}", name);
    }
    text += "  of bound\n";
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      const ClassResult::Row& row = result.rows[s];
      text += fmt::format("{:<16}", kSubjectNames[s]);
      for (const Metric metric : {Metric::kMajor, Metric::kEffective, Metric::kAxis, Metric::kLevel, Metric::kColour}) {
        const Measure& of = row.measures[static_cast<std::size_t>(metric)];
        text += fmt::format(
            "{:>19}", of.count == 0 && of.lost > 0 ? "lost"
                      : of.count == 0              ? "-"
                                      : fmt::format("{:.1e} / {:.1e}{}", of.worst, of.mean(), of.lost > 0 ? "*" : ""));
      }
      text += verdict(row) == "no bound" ? "         -\n" : fmt::format("{:>10.3f}\n", worst_share(row));
    }
  }
  text += "\n* others have no finite value\n";
  if (!study.jumps.empty()) {
    text += fmt::format("\nJumps over one ulp of a derivative{:<2}{:>22}{:>8}{:>12}{:>10}{:>8}\n", "", "places", "over",
                        "octaves", "bound", "codes");
  }
  for (const JumpRow& row : study.jumps) {
    text += fmt::format("{:<20}{:<16}{:<22}{:>6}{:>8}{:>12.4f}{:>10}{:>8.3f}\n", subject_name(row.subject),
                        kCauseNames[static_cast<std::size_t>(row.cause)], origin(row.cause), row.places,
                        row.over_a_step.size(), row.worst_level,
                        std::isfinite(row.bound) ? fmt::format("{:.4f}", row.bound) : "-", row.worst_colour);
  }
  const std::vector<std::string> broken = study.broken();
  for (const std::string& what : broken) text += "BROKEN " + what + "\n";
  if (broken.empty())
    text += fmt::format("\nAll bounds hold: {} of classes, subjects and quantities.\n", bound_count(study));
  return text;
}

}  // namespace feline::stability
