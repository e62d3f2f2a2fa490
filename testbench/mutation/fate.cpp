// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/fate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>

#include "testbench/atomic_file.h"
#include "testbench/mutation/aiger.h"
#include "testbench/mutation/leaf_mutants.h"
#include "testbench/mutation/leaf_trial.h"
#include "testbench/page/process.h"
#include "testbench/parallel.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

std::string codes_of(std::span<Fate* const> fates) {
  std::string codes;
  for (const Fate* const fate : fates) codes += fmt::format("{}\n", code(fate->mutant));
  return codes;
}

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

std::string run_program(const std::vector<std::string>& command, const std::string& input) {
  const page::Finished finished = page::run_process(command, input);
  if (finished.code != 0) {
    throw std::runtime_error(
        fmt::format("{}: exit code {}\n{}{}", command.front(), finished.code, finished.output, finished.errors));
  }
  return finished.output;
}

std::string trials_hash(const std::filesystem::path& source) {
  std::set<std::filesystem::path> files;
  for (const char* const room :
       {"rtl", "model", "tables", "tables/generated", "testbench", "testbench/cosim", "testbench/mutation",
        "testbench/mutation/rules", "testbench/prove", "testbench/prove/rtl_leaves", "tests/model", "tests/support"}) {
    for (const auto& entry : std::filesystem::directory_iterator(source / room)) {
      // survivors.json is no part of a trial.
      if (entry.is_regular_file() && entry.path().extension() != ".json") files.insert(entry.path());
    }
  }
  std::string all;
  for (const std::filesystem::path& file : files) all += content_hash(file);
  return all;
}

namespace {

// On all domains of one wrapper.
void try_leaf(const StageMutants& stage, std::string_view wrapper, const std::vector<const prove::Leaf*>& leaves,
              bool quick, const Workshop& workshop, std::vector<Fate>& fates) {
  constexpr std::uint64_t kQuick = std::uint64_t{1} << 24;
  constexpr std::uint64_t kMost = std::uint64_t{1} << 32;
  const std::filesystem::path directory = workshop.directory / stage.stage() / wrapper;
  std::filesystem::create_directories(directory);
  const LeafMutants in_leaf(stage, wrapper, workshop.source, directory);
  std::vector<Fate*> open;
  std::vector<Mutant> mutants;
  for (Fate& fate : fates) {
    const auto mutant = in_leaf.in_leaf(fate.mutant);
    if (!fate.tier.empty() || fate.proved() || !mutant) continue;
    open.push_back(&fate);
    mutants.push_back(*mutant);
  }
  std::optional<Aiger> logic;
  for (const prove::Leaf* const leaf : leaves) {
    if (open.empty()) return;
    const std::uint64_t limit = quick ? kQuick : leaf->complete ? leaf->domain.count : kMost;
    const std::uint64_t inputs_tried = std::min(limit, leaf->domain.count);
    const std::string key = workshop.cache.key(
        {"leaf", fmt::format("{}", inputs_tried), workshop.trials, stage.text(), leaf->name, codes_of(open)});
    nlohmann::json inputs = nlohmann::json::parse(workshop.cache.read(key).value_or("[]"));
    if (inputs.size() != open.size()) {
      if (!logic) logic = in_leaf.logic(mutants);
      std::vector<std::uint64_t> codes;
      for (const Mutant& mutant : mutants) codes.push_back(code(mutant));
      inputs = nlohmann::json::array();
      for (const auto& input : differing_inputs(*leaf, *logic, codes, inputs_tried)) {
        inputs.push_back(input ? nlohmann::json(*input) : nlohmann::json());
      }
      workshop.cache.write(key, inputs.dump());
    }
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (!inputs[i].is_null()) {
        open[i]->tier = kExhaustive;
        open[i]->stage = leaf->name;
        open[i]->lookup = inputs[i];
      } else if (leaf->complete && inputs_tried == leaf->domain.count) {
        open[i]->logic = Fate::Logic::kSame;
      }
    }
    for (std::size_t i = open.size(); i-- > 0;) {
      if (open[i]->tier.empty() && !open[i]->proved()) continue;
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
      mutants.erase(mutants.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

}  // namespace

void try_mutants(const StageMutants& stage, const std::vector<std::string>& tiers, const Workshop& workshop,
                 std::vector<Fate>& fates) {
  constexpr std::size_t kTogether = 500;  // every run tries the unit without a mutant first
  const std::string program = (workshop.directory / "build" / ("feline_mutated_" + stage.stage())).string();
  std::vector<std::string> command{program};
  command.insert(command.end(), tiers.begin(), tiers.end());
  std::vector<Fate*> open;
  for (Fate& fate : fates) {
    if (fate.tier.empty() && !fate.proved()) open.push_back(&fate);
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
      lines = run_program(command, codes);
      workshop.cache.write(key, *lines);
    }
    tell_fates(part, *lines);
    progress.advance(part.size());
  }
}

void try_leaves(const StageMutants& stage, bool quick, const Workshop& workshop, std::vector<Fate>& fates) {
  std::map<std::string_view, std::vector<const prove::Leaf*>> by_wrapper;
  for (const prove::Leaf& leaf : prove::all_leaves()) {
    if (leaf.stage() == stage.stage()) by_wrapper[leaf.wrapper].push_back(&leaf);
  }
  for (const auto& [wrapper, leaves] : by_wrapper) try_leaf(stage, wrapper, leaves, quick, workshop, fates);
}

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
        workshop.cache.key({same ? "same logic" : "observed", workshop.trials, stage.text(), codes_of(part)});
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
