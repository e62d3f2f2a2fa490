// SPDX-License-Identifier: Apache-2.0
// By SAT.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

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
    if (port == aiger.inputs[i] || port == "mutant" || port == "any") continue;
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

// What is asked of one mutant: it stands for others, too, if they are bits of the same word.
struct Question {
  Mutant mutant;
  std::vector<Fate*> fates;
};

// A word is anything, which differs, so that of bits of ROMs it is asked only whether anybody sees it.
std::vector<Question> open_questions(Fate::Logic wanted, std::vector<Fate>& fates) {
  std::vector<Question> questions;
  std::map<std::uint64_t, std::size_t> words;  // their questions
  for (Fate& fate : fates) {
    const bool is_of_rom = fate.mutant.kind == Kind::kRomBit;
    if (!fate.is_open() || (is_of_rom && wanted == Fate::Logic::kSame)) continue;
    Mutant asked = fate.mutant;
    if (is_of_rom) {
      asked.bit = 0;
      const auto [word, is_new] = words.emplace(code(asked), questions.size());
      if (!is_new) {
        questions[word->second].fates.push_back(&fate);
        continue;
      }
    }
    questions.push_back({asked, {&fate}});
  }
  return questions;
}

}  // namespace

void compare_logic(const StageMutants& stage, Fate::Logic wanted, const Workshop& workshop, std::vector<Fate>& fates) {
  const std::vector<Question> open = open_questions(wanted, fates);
  if (open.empty()) return;
  std::vector<Mutant> mutants;
  for (const Question& question : open) mutants.push_back(question.mutant);
  const bool same = wanted == Fate::Logic::kSame;
  constexpr std::size_t kTogether = 50;  // what is lost when it is stopped
  std::optional<Aiger> logic;
  std::optional<Aiger> right;
  Progress progress(fmt::format("{}: {}", stage.stage(), same ? "the same logic" : "a difference nobody sees"),
                    open.size());
  for (std::size_t first = 0; first < open.size(); first += kTogether) {
    const auto part = std::span(open).subspan(first, std::min(kTogether, open.size() - first));
    std::vector<Fate*> told;
    for (const Question& question : part) told.insert(told.end(), question.fates.begin(), question.fates.end());
    const std::string key =
        workshop.cache.key({same ? "same logic" : "observed", workshop.proofs, stage.text(), codes_of(told)});
    nlohmann::json verdicts = nlohmann::json::parse(workshop.cache.read(key).value_or("[]"));
    if (verdicts.size() != part.size()) {
      if (!logic) logic = read_aiger(stage.logic(mutants, !same));
      if (!right) right = with_input(*logic, "mutant", 0);
      std::vector<Verdict> found(part.size());
      for_each_index(0, static_cast<std::int64_t>(part.size()), [&](std::int64_t i) {
        const auto place = static_cast<std::size_t>(i);
        const Mutant& mutant = part[place].mutant;
        const Aiger wrong = with_input(*logic, "mutant", code(mutant));
        found[place] = same ? Verdict{same_logic(*right, wrong)} : whether_observed(stage, mutant, *right, wrong);
      });
      verdicts = nlohmann::json::array();
      for (const Verdict& verdict : found) verdicts.push_back({{"proved", verdict.proved}, {"beat", verdict.beat}});
      workshop.cache.write(key, verdicts.dump());
    }
    progress.advance(part.size());
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (Fate* const fate : part[i].fates) {
        if (verdicts[i]["proved"]) fate->logic = wanted;
        if (!same) fate->differs = verdicts[i]["beat"];
      }
    }
  }
}

}  // namespace feline::mutation
