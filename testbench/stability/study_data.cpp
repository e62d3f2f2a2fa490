// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/study_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace feline::stability {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json to_json(const Case& of) {
  const auto shortest = [](float value) { return fmt::format("{}", value); };
  const Lookup& at = of.lookup;
  return {{"size", fmt::format("{}x{}", texture_of(of).width(), texture_of(of).height())},
          {"s", shortest(at.s)},
          {"t", shortest(at.t)},
          {"dsdx", shortest(at.dsdx)},
          {"dtdx", shortest(at.dtdx)},
          {"dsdy", shortest(at.dsdy)},
          {"dtdy", shortest(at.dtdy)}};
}

Json to_json(const Measure& measure) {
  Json json{{"count", measure.count}, {"lost", measure.lost}};
  if (measure.count > 0) {
    json["worst"] = measure.worst;
    json["mean"] = measure.mean();
  }
  if (measure.count + measure.lost > 0) json["worst_lookup"] = to_json(measure.worst_case);
  json["bounded"] = measure.bounded;
  if (measure.bounded > 0) {
    json["worst_share_of_bound"] = number(measure.worst_share);
    json["worst_share_lookup"] = to_json(measure.worst_share_case);
    json["holds"] = measure.holds();
  }
  return json;
}

Json to_json(const ClassResult& result) {
  Json json{{"name", result.of->name}, {"description", result.of->description}, {"lookups", result.count}};
  for (std::size_t s = 0; s < kSubjects.size(); ++s) {
    const ClassResult::Row& row = result.rows[s];
    Json subject{{"name", kSubjectNames[s]},
                 {"verdict", verdict(row)},
                 {"probe_counts_of_the_other_side", row.other_side},
                 {"other_probe_counts", row.other_probes}};
    for (std::size_t m = 0; m < kMetrics.size(); ++m) subject["errors"][kMetricKeys[m]] = to_json(row.measures[m]);
    json["subjects"].push_back(std::move(subject));
  }
  return json;
}

Json to_json(const JumpRow& row) {
  return {{"subject", subject_name(row.subject)},
          {"cause", kCauseNames[static_cast<std::size_t>(row.cause)]},
          {"origin", origin(row.cause)},
          {"places", row.places},
          {"over_a_step", row.over_a_step.size()},
          {"worst_level", row.worst_level},
          {"worst_colour", row.worst_colour},
          {"worst_probes", row.worst_probes},
          {"worst_level_of_feline_there", row.worst_exact_level},
          {"bound", number(row.bound)},
          {"worst_share_of_way_to_boundary", row.worst_share},
          {"places_without_promise", row.unpromised},
          {"holds", row.holds},
          {"path", row.worst.path},
          {"lookup", to_json(row.worst.at)}};
}

Json to_json(const NonFiniteRow& row) {
  Json json{{"what", row.what}, {"lookups", row.count}};
  for (std::size_t s = 0; s < kSubjects.size(); ++s) {
    const NonFiniteRow::Result& result = row.results[s];
    Json subject{{"name", kSubjectNames[s]},
                 {"colour_defined", result.colour_defined},
                 {"level_defined", result.level_defined},
                 {"coarsest_level", result.coarsest}};
    if (is_unit(kSubjects[s])) {
      subject["status_right"] = result.flagged;
      subject["holds"] = row.holds(kSubjects[s]);
    }
    json["subjects"].push_back(std::move(subject));
  }
  return json;
}

}  // namespace

std::string subject_name(const std::optional<Subject>& subject) {
  return subject ? std::string(kSubjectNames[static_cast<std::size_t>(*subject)]) : "Feline at 200 bits";
}

std::string_view origin(Cause cause) {
  switch (cause) {
    case Cause::kProbeCount: return "Feline";
    case Cause::kLongerVector:
    case Cause::kTableCell: return "Simple or Table Feline";
    case Cause::kExponent:
    case Cause::kMantissa: return "number format";
    case Cause::kRounding: return "rounding";
    case Cause::kOther: break;
  }
  return "";
}

double worst_share(const ClassResult::Row& row) {
  return std::ranges::max(row.measures, {}, &Measure::worst_share).worst_share;
}

bool has_bound(const ClassResult::Row& row) {
  return std::ranges::any_of(row.measures, [](const Measure& m) { return m.bounded > 0; });
}

std::string verdict(const ClassResult::Row& row) {
  if (!has_bound(row)) return "no bound";
  return worst_share(row) <= 1 ? "holds" : "broken";
}

std::string measure_text(const Measure& measure) {
  if (measure.count + measure.lost == 0) return "-";
  if (measure.count == 0) return "lost";
  const std::string text = measure.worst == 0 ? "0" : fmt::format("{:.1e} / {:.1e}", measure.worst, measure.mean());
  return measure.lost == 0 ? text
                           : fmt::format("{}, {:.0f} % lost", text,
                                         100.0 * static_cast<double>(measure.lost) /
                                             static_cast<double>(measure.count + measure.lost));
}

std::uint64_t bound_count(const Study& study) {
  std::uint64_t count = 0;
  for (const ClassResult& result : study.classes) {
    for (const ClassResult::Row& row : result.rows) {
      count += static_cast<std::uint64_t>(
          std::ranges::count_if(row.measures, [](const Measure& m) { return m.bounded > 0; }));
    }
  }
  return count;
}

nlohmann::ordered_json to_json(const Study& study) {
  Json json{{"precision_bits", 200},
            {"lookups_a_class", study.options.count},
            {"seed", study.options.seed},
            {"classes", Json::array()}};
  for (const ClassResult& result : study.classes) json["classes"].push_back(to_json(result));
  json["decades"] = Json::array();
  for (const auto& [decade, errors] : study.decades) {
    Json row{{"condition", std::pow(10.0, decade)}};
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      row["subjects"].push_back({{"name", kSubjectNames[s]},
                                 {"major", number(errors.major[s])},
                                 {"minor", number(errors.minor[s])},
                                 {"effective", number(errors.effective[s])}});
    }
    json["decades"].push_back(std::move(row));
  }
  json["jumps"] = Json::array();
  for (const JumpRow& row : study.jumps) json["jumps"].push_back(to_json(row));
  json["probe_steps"] = Json::array();
  for (const ProbeStep& step : study.probe_steps) {
    Json row{{"from_probes", step.probes},
             {"feline", {{"ratio", number(step.ideal_place)}, {"level", number(step.ideal_level)}}}};
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      row["subjects"].push_back(
          {{"name", kSubjectNames[s]}, {"ratio", number(step.place[s])}, {"level", number(step.level[s])}});
    }
    json["probe_steps"].push_back(std::move(row));
  }
  json["non_finite"] = Json::array();
  for (const NonFiniteRow& row : study.non_finite) json["non_finite"].push_back(to_json(row));
  json["broken"] = study.broken();
  return json;
}

}  // namespace feline::stability
