// SPDX-License-Identifier: Apache-2.0
// By SAT.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "testbench/atomic_file.h"
#include "testbench/mutation/aiger.h"
#include "testbench/mutation/fate.h"
#include "testbench/page/process.h"
#include "testbench/parallel.h"
#include "testbench/progress.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

// What a proof comes to, as the cache has it.
enum class Verdict : char { kUnknown = '0', kProved = '1', kDiffers = 'd' };

bool says(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

// What abc says; it looks at its own limit of time in places only. Throws std::runtime_error when it fails otherwise.
std::string ask_abc(const std::string& commands) {
  constexpr int kPatience = 20;    // seconds
  constexpr int kOutOfTime = 124;  // of timeout
  const std::vector<std::string> command{"timeout", std::to_string(kPatience), "yosys-abc", "-q", commands};
  const page::Finished finished = page::run_process(command, "");
  if (finished.code != 0 && finished.code != kOutOfTime) {
    throw std::runtime_error(
        fmt::format("yosys-abc: exit code {}\n{}{}", finished.code, finished.output, finished.errors));
  }
  return finished.output;
}

bool same_logic(const Aiger& right, const Aiger& wrong) {
  const std::filesystem::path work = std::filesystem::temp_directory_path();
  const AtomicFile right_file(work / "feline-right.aig");
  const AtomicFile wrong_file(work / "feline-mutant.aig");
  write_text(right_file.temporary(), to_binary(cut_latches(right)));
  write_text(wrong_file.temporary(), to_binary(cut_latches(wrong)));
  return says(ask_abc(fmt::format("&r {}; &cec {}", right_file.temporary().string(), wrong_file.temporary().string())),
              "Networks are equivalent");
}

bool unobserved(const Aiger& right, const Aiger& wrong) {
  const AtomicFile file(std::filesystem::temp_directory_path() / "feline-difference.aig");
  write_text(file.temporary(), to_binary(observed_difference(right, wrong)));
  return says(ask_abc(fmt::format("read_aiger {}; strash; scleanup; scorr; pdr", file.temporary().string())),
              "Property proved");
}

// Pipelines, whose proofs of streams (feline prove) leave only what a beat makes of another one.
constexpr std::array<std::string_view, 5> kPipelines{"group", "footprint", "plan", "address", "filter"};
constexpr std::size_t kMostRegisters = 6;

// Whether any beat comes out otherwise.
std::optional<bool> flows_otherwise(const Aiger& right, const Aiger& wrong) {
  const Aiger flow = steady_flow(right, kMostRegisters + 1);
  if (!comes_out(flow)) throw std::runtime_error("a stage of more registers than a pipeline may have");
  const AtomicFile file(std::filesystem::temp_directory_path() / "feline-flow.aig");
  write_text(file.temporary(), to_binary(difference(flow, steady_flow(wrong, kMostRegisters + 1))));
  const std::string said = ask_abc(fmt::format("read_aiger {}; strash; dc2; fraig; iprove", file.temporary().string()));
  if (says(said, "UNSATISFIABLE")) return false;
  if (says(said, "SATISFIABLE")) return true;
  return std::nullopt;
}

Verdict whether_observed(const StageMutants& stage, const Mutant& mutant, const Aiger& right, const Aiger& wrong) {
  const bool is_pipeline = std::ranges::find(kPipelines, stage.stage()) != kPipelines.end();
  if (is_pipeline && !stage.in_stream(mutant)) {
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
