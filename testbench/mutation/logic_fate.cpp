// SPDX-License-Identifier: Apache-2.0
// By SAT.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "testbench/mutation/fate.h"
#include "testbench/mutation/sat.h"
#include "testbench/parallel.h"
#include "testbench/progress.h"

namespace feline::mutation {
namespace {

// What a proof comes to, as the cache has it.
enum class Verdict : char { kUnknown = '0', kProved = '1', kDiffers = 'd' };

Verdict whether_observed(const StageMutants& stage, const Mutant& mutant, const Aiger& right, const Aiger& wrong) {
  if (is_pipeline(stage) && !stage.in_stream(mutant)) {
    // What SAT does not decide of one beat it does not decide of all cycles.
    const auto otherwise = flows_otherwise(right, wrong);
    if (!otherwise) return Verdict::kUnknown;
    return *otherwise ? Verdict::kDiffers : Verdict::kProved;
  }
  return unobserved(right, wrong) ? Verdict::kProved : Verdict::kUnknown;
}

}  // namespace

void compare_logic(const StageMutants& stage, Fate::Logic wanted, const Workshop& workshop, std::vector<Fate>& fates) {
  std::vector<Fate*> open;
  std::vector<Mutant> mutants;
  for (Fate& fate : fates) {
    if (!fate.tier.empty() || fate.proved() || fate.mutant.kind == Kind::kRomBit) continue;
    open.push_back(&fate);
    mutants.push_back(fate.mutant);
  }
  if (open.empty()) return;
  const bool same = wanted == Fate::Logic::kSame;
  constexpr std::size_t kTogether = 50;  // what is lost when it is stopped
  std::optional<Aiger> logic;
  std::optional<Aiger> right;
  std::string known;
  Progress progress(fmt::format("{}: {}", stage.stage(), same ? "the same logic" : "a difference nobody sees"),
                    open.size());
  for (std::size_t first = 0; first < open.size(); first += kTogether) {
    const auto part = std::span(open).subspan(first, std::min(kTogether, open.size() - first));
    const std::string key =
        workshop.cache.key({same ? "same logic" : "observed", workshop.proofs, stage.text(), codes_of(part)});
    std::string verdicts = workshop.cache.read(key).value_or("");
    if (verdicts.size() != part.size()) {
      if (!logic) logic = read_aiger(stage.logic(mutants));
      if (!right) right = with_input(*logic, "mutant", 0);
      verdicts.assign(part.size(), static_cast<char>(Verdict::kUnknown));
      for_each_index(0, static_cast<std::int64_t>(part.size()), [&](std::int64_t i) {
        const auto place = static_cast<std::size_t>(i);
        const Mutant& mutant = part[place]->mutant;
        const Aiger wrong = with_input(*logic, "mutant", code(mutant));
        const Verdict verdict = !same                       ? whether_observed(stage, mutant, *right, wrong)
                                : same_logic(*right, wrong) ? Verdict::kProved
                                                            : Verdict::kUnknown;
        verdicts[place] = static_cast<char>(verdict);
      });
      workshop.cache.write(key, verdicts);
    }
    progress.advance(part.size());
    known += verdicts;
  }
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto verdict = static_cast<Verdict>(known[i]);
    if (verdict == Verdict::kProved) open[i]->logic = wanted;
    if (verdict == Verdict::kDiffers) open[i]->differs = true;
  }
}

}  // namespace feline::mutation
