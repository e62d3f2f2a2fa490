// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/mutation_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "testbench/error.h"
#include "testbench/json_input.h"
#include "testbench/median.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

// What a reason begins with. A beat that comes out otherwise refutes the first.
constexpr std::string_view kEquivalent = "equivalent: ";
constexpr std::string_view kUnseen = "nothing can be seen: ";

bool is_reason(const std::string& text) {
  for (const std::string_view beginning : {kEquivalent, kUnseen}) {
    if (text.starts_with(beginning) && text.size() > beginning.size()) return true;
  }
  return false;
}

// Rounded down, so that only all of them are 100 %.
std::string percent(std::size_t part, std::size_t whole) {
  if (whole == 0) return "-";
  const std::size_t hundredths = 10000 * part / whole;
  return fmt::format("{}.{:02} %", hundredths / 100, hundredths % 100);
}

std::size_t at(const std::map<std::string, std::size_t>& counts, const std::string& name) {
  const auto found = counts.find(name);
  return found == counts.end() ? 0 : found->second;
}

StageResult sum_of(const std::vector<StageResult>& results) {
  StageResult sum;
  sum.stage = "all";
  for (const StageResult& result : results) {
    sum.sites += result.sites;
    sum.fates.insert(sum.fates.end(), result.fates.begin(), result.fates.end());
    for (const auto& [tier, count] : result.killed) sum.killed[tier] += count;
    sum.same += result.same;
    sum.unobserved += result.unobserved;
    for (const auto& [mutant, reason] : result.known) sum.known.emplace(result.stage + mutant, reason);
    sum.open.insert(sum.open.end(), result.open.begin(), result.open.end());
  }
  return sum;
}

}  // namespace

KnownSurvivors read_known_survivors(const std::filesystem::path& file) {
  constexpr std::string_view kLegal = "{\"STAGE\": [{\"reason\": \"...\", \"mutants\": [\"...\"]}]}";
  const std::string text = read_text(file, "survivors", kLegal);
  const auto json = parse_json(text, file.string(), kLegal);
  if (!json.is_object()) bad_input(file.string(), "JSON", "something else", kLegal);
  KnownSurvivors known;
  for (const auto& [stage, groups] : json.items()) {
    for (const auto& group : groups) {
      const bool whole = group.is_object() && group.contains("reason") && group["reason"].is_string() &&
                         group.contains("mutants") && group["mutants"].is_array();
      if (!whole) bad_input(file.string(), stage, group.dump(), kLegal);
      const std::string reason = group["reason"];
      if (!is_reason(reason)) {
        bad_input(file.string(), stage, reason, fmt::format("\"{}...\" or \"{}...\"", kEquivalent, kUnseen));
      }
      for (const auto& mutant : group["mutants"]) {
        if (!mutant.is_string() || !known[stage].emplace(mutant, group["reason"]).second) {
          bad_input(file.string(), stage, mutant.dump(), "each mutant once");
        }
      }
    }
  }
  return known;
}

std::size_t StageResult::kills() const {
  std::size_t sum = 0;
  for (const auto& [tier, count] : killed) sum += count;
  return sum;
}

StageResult judge(const std::string& stage, std::size_t sites, std::vector<Fate> fates, const KnownSurvivors& known) {
  StageResult result;
  result.stage = stage;
  result.sites = sites;
  result.fates = std::move(fates);
  const auto reasons = known.find(stage);
  std::vector<double> times;
  for (const Fate& fate : result.fates) {
    const bool has_reason = reasons != known.end() && reasons->second.contains(fate.name);
    const bool is_refuted =
        has_reason && !fate.differs.empty() && reasons->second.at(fate.name).starts_with(kEquivalent);
    if (has_reason && (!fate.is_open() || is_refuted)) result.stale.push_back(fate.name);
    if (!fate.tier.empty()) {
      ++result.killed[fate.tier];
      if (fate.milliseconds > 0) times.push_back(fate.milliseconds);  // not of what is inferred
    } else if (fate.logic == Fate::Logic::kSame) {
      ++result.same;
    } else if (fate.logic == Fate::Logic::kUnobserved) {
      ++result.unobserved;
    } else if (has_reason && !is_refuted) {
      result.known[fate.name] = reasons->second.at(fate.name);
    } else {
      result.open.push_back(fate.differs.empty() ? fate.name
                                                 : fmt::format("{} (differs: {})", fate.name, fate.differs));
    }
  }
  result.median_milliseconds = median(std::move(times));
  return result;
}

nlohmann::ordered_json to_json(const std::vector<StageResult>& results, std::optional<std::uint64_t> seed) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (seed) json["seed"] = *seed;
  json["stages"] = nlohmann::ordered_json::object();
  for (const StageResult& result : results) {
    nlohmann::ordered_json named = nlohmann::ordered_json::object();
    for (const Fate& fate : result.fates) {
      if (fate.stage.empty()) continue;
      named[fate.stage] = named.value(fate.stage, 0) + 1;
    }
    json["stages"][result.stage] = {{"sites", result.sites},      {"mutants", result.fates.size()},
                                    {"killed", result.killed},    {"named", named},
                                    {"proved_same", result.same}, {"proved_unobserved", result.unobserved},
                                    {"known", result.known},      {"open", result.open},
                                    {"stale", result.stale},      {"median_milliseconds", result.median_milliseconds}};
  }
  return json;
}

std::string to_text(const std::vector<StageResult>& results, const std::vector<std::string>& tiers) {
  std::string out = fmt::format(
      "| stage | mutants | {} | proved the same | unobserved | with a reason | open | killed of those not proved "
      "| median |\n|---|--:|{}--:|--:|--:|--:|--:|--:|\n",
      fmt::join(tiers, " | "), fmt::join(std::vector<std::string>(tiers.size(), "--:|"), ""));
  std::vector<StageResult> rows = results;
  if (results.size() > 1) rows.push_back(sum_of(results));
  for (const StageResult& row : rows) {
    out += fmt::format("| {} | {} |", row.stage, row.fates.size());
    for (const std::string& tier : tiers) out += fmt::format(" {} |", at(row.killed, tier));
    out += fmt::format(" {} | {} | {} | {} | {} | {} |\n", row.same, row.unobserved, row.known.size(), row.open.size(),
                       percent(row.kills(), row.fates.size() - row.same - row.unobserved),
                       row.stage == "all" ? "" : fmt::format("{:.1f} ms", row.median_milliseconds));
  }
  for (const StageResult& result : results) {
    for (const std::string& name : result.open) out += fmt::format("OPEN: {}: {}\n", result.stage, name);
    for (const std::string& name : result.stale) out += fmt::format("STALE REASON: {}: {}\n", result.stage, name);
  }
  return out;
}

}  // namespace feline::mutation
