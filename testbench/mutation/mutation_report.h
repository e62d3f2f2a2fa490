// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "testbench/mutation/fate.h"

namespace feline::mutation {

// Survivors without a proof that have a reason all the same: of each stage, by the mutant's description, the reason.
// One that begins with "equivalent: " is refuted by a beat that comes out otherwise (Fate::differs); one that begins
// with "nothing can be seen: " says why nobody can see what differs.
using KnownSurvivors = std::map<std::string, std::map<std::string, std::string>>;

// {"walk": [{"reason": "...", "mutants": ["...", ...]}, ...], ...}. Throws InputError naming the file, the field and
// what is legal; also for a mutant that is there twice or has no reason.
KnownSurvivors read_known_survivors(const std::filesystem::path& file);

// What became of the mutants of one stage.
struct StageResult {
  std::string stage;
  std::size_t sites = 0;
  std::vector<Fate> fates;
  std::map<std::string, std::size_t> killed;  // by tier
  std::size_t same = 0;                       // proved, of the survivors
  std::size_t unobserved = 0;
  std::map<std::string, std::string> known;  // not proved, but with a reason
  std::vector<std::string> open;             // nothing is known of these
  std::vector<std::string> stale;            // with a reason, but killed, proved, or refuted
  double median_milliseconds = 0;            // to kill

  std::size_t kills() const;
};

StageResult judge(const std::string& stage, std::size_t sites, std::vector<Fate> fates, const KnownSurvivors& known);

// `seed`: of the choice of mutants, if there was one.
nlohmann::ordered_json to_json(const std::vector<StageResult>& results, std::optional<std::uint64_t> seed);
// A table in Markdown, a row a stage, a column a tier, and the survivors of which nothing is known.
std::string to_text(const std::vector<StageResult>& results, const std::vector<std::string>& tiers);

}  // namespace feline::mutation
