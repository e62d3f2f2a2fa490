// SPDX-License-Identifier: Apache-2.0
// By SAT.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "testbench/mutation/fate.h"
#include "testbench/mutation/sat.h"
#include "testbench/parallel.h"
#include "testbench/progress.h"

namespace feline::mutation {
namespace {

// What a proof comes to.
struct Verdict {
  bool proved = false;
  std::string beat{};  // that comes out otherwise
};

// "plan_i 0x1f, sampler_i 0x0": ports of more bits than one.
std::string beat_text(const Aiger& aiger, const std::vector<bool>& inputs) {
  std::map<std::string, std::vector<unsigned>> digits;  // of each port, the least first
  for (std::size_t i = 0; i < aiger.inputs.size(); ++i) {
    const std::string port = port_of(aiger.inputs[i]);
    if (port == aiger.inputs[i] || port == "mutant") continue;
    const std::size_t bit = std::stoul(aiger.inputs[i].substr(port.size() + 1));
    std::vector<unsigned>& of_port = digits[port];
    of_port.resize(std::max(of_port.size(), bit / 4 + 1));
    of_port[bit / 4] |= unsigned{inputs[i]} << bit % 4;
  }
  std::vector<std::string> ports;
  for (auto& [port, of_port] : digits) {
    std::ranges::reverse(of_port);
    ports.push_back(fmt::format("{} 0x{:x}", port, fmt::join(of_port, "")));
  }
  return fmt::format("{}", fmt::join(ports, ", "));
}

Verdict whether_observed(const StageMutants& stage, const Mutant& mutant, const Aiger& right, const Aiger& wrong) {
  if (is_pipeline(stage) && !stage.in_stream(mutant)) {
    // What SAT does not decide of one beat it does not decide of all cycles.
    const Satisfied otherwise = flows_otherwise(right, wrong);
    if (otherwise.answer == Satisfied::Answer::kNever) return {true};
    if (otherwise.answer == Satisfied::Answer::kSometimes) return {false, beat_text(right, otherwise.inputs)};
    return {};
  }
  return {unobserved(right, wrong)};
}

}  // namespace

void compare_logic(const StageMutants& stage, Fate::Logic wanted, const Workshop& workshop, std::vector<Fate>& fates) {
  std::vector<Fate*> open;
  std::vector<Mutant> mutants;
  for (Fate& fate : fates) {
    if (!fate.is_open() || fate.mutant.kind == Kind::kRomBit) continue;
    open.push_back(&fate);
    mutants.push_back(fate.mutant);
  }
  if (open.empty()) return;
  const bool same = wanted == Fate::Logic::kSame;
  constexpr std::size_t kTogether = 50;  // what is lost when it is stopped
  std::optional<Aiger> logic;
  std::optional<Aiger> right;
  Progress progress(fmt::format("{}: {}", stage.stage(), same ? "the same logic" : "a difference nobody sees"),
                    open.size());
  for (std::size_t first = 0; first < open.size(); first += kTogether) {
    const auto part = std::span(open).subspan(first, std::min(kTogether, open.size() - first));
    const std::string key =
        workshop.cache.key({same ? "same logic" : "observed", workshop.proofs, stage.text(), codes_of(part)});
    nlohmann::json verdicts = nlohmann::json::parse(workshop.cache.read(key).value_or("[]"));
    if (verdicts.size() != part.size()) {
      if (!logic) logic = read_aiger(stage.logic(mutants, !same));
      if (!right) right = with_input(*logic, "mutant", 0);
      std::vector<Verdict> found(part.size());
      for_each_index(0, static_cast<std::int64_t>(part.size()), [&](std::int64_t i) {
        const auto place = static_cast<std::size_t>(i);
        const Mutant& mutant = part[place]->mutant;
        const Aiger wrong = with_input(*logic, "mutant", code(mutant));
        found[place] = same ? Verdict{same_logic(*right, wrong)} : whether_observed(stage, mutant, *right, wrong);
      });
      verdicts = nlohmann::json::array();
      for (const Verdict& verdict : found) verdicts.push_back({{"proved", verdict.proved}, {"beat", verdict.beat}});
      workshop.cache.write(key, verdicts.dump());
    }
    progress.advance(part.size());
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (verdicts[i]["proved"]) part[i]->logic = wanted;
      if (!same) part[i]->differs = verdicts[i]["beat"];
    }
  }
}

}  // namespace feline::mutation
