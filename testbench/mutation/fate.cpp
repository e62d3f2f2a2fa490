// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/fate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "testbench/progress.h"

namespace feline::mutation {

std::string codes_of(std::span<Fate* const> fates) {
  std::string codes;
  for (const Fate* const fate : fates) codes += fmt::format("{}\n", code(fate->mutant));
  return codes;
}

namespace {

void tell_fates(std::span<Fate* const> fates, const std::string& lines) {
  std::map<std::uint64_t, nlohmann::json> by_code;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    nlohmann::json json = nlohmann::json::parse(line);
    const std::uint64_t code = json["code"];
    by_code.emplace(code, std::move(json));
  }
  for (Fate* const fate : fates) {
    const auto found = by_code.find(code(fate->mutant));
    if (found == by_code.end()) throw std::runtime_error("feline_mutated: says nothing of a mutant");
    const nlohmann::json& line = found->second;
    if (!line.contains("tier")) continue;
    fate->tier = line["tier"];
    fate->stage = line["stage"];
    fate->lookup = line["lookup"];
    fate->cycles = line["cycles"];
    fate->milliseconds = line["milliseconds"];
  }
}

}  // namespace

void try_mutants(const StageMutants& stage, const std::vector<std::string>& tiers, const Workshop& workshop,
                 std::vector<Fate>& fates) {
  constexpr std::size_t kTogether = 2000;  // every run tries the unit without a mutant first
  const std::string program = (workshop.directory / "build" / ("feline_mutated_" + stage.stage())).string();
  std::vector<std::string> command{program};
  command.insert(command.end(), tiers.begin(), tiers.end());
  std::vector<Fate*> open;
  for (Fate& fate : fates) {
    if (fate.is_open()) open.push_back(&fate);
  }
  Progress progress(fmt::format("{}: {}", stage.stage(), fmt::join(tiers, ", ")), open.size());
  progress.show();
  bool built = false;
  for (std::size_t first = 0; first < open.size(); first += kTogether) {
    const auto part = std::span(open).subspan(first, std::min(kTogether, open.size() - first));
    const std::string codes = codes_of(part);
    const std::string key =
        workshop.cache.key({"mutants", workshop.trials, stage.text(), fmt::format("{}", fmt::join(tiers, ",")), codes});
    std::optional<std::string> lines = workshop.cache.read(key);
    if (!lines) {
      const auto script = workshop.source / "testbench" / "mutation" / "build.sh";
      if (!built) run_program({script.string(), workshop.directory.string(), stage.stage()});
      built = true;
      lines = run_trials(command, codes);
      workshop.cache.write(key, *lines);
    }
    tell_fates(part, *lines);
    progress.advance(part.size());
  }
}

}  // namespace feline::mutation
