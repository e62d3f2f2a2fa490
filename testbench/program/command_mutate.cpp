// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "tables/stages.h"
#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/mutation/model_mutants.h"
#include "testbench/mutation/mutation_report.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"

namespace feline {
namespace {

struct MutateOptions {
  std::string stages = "all";
  std::size_t count = 2000;
  bool roms = false;
  bool model = false;
  std::uint64_t seed = 1;
  std::string known;
  std::string source = FELINE_SOURCE_DIR;
  std::string output = "feline-mutants";
  bool json = false;
};

std::vector<std::string_view> stage_names() {
  std::vector<std::string_view> names(kStageNames.begin(), kStageNames.end());
  names.push_back(mutation::kUnitName);
  return names;
}

std::vector<std::string> chosen_stages(const std::string& text) {
  const std::vector<std::string_view> names = stage_names();
  if (text == "all") return {names.begin(), names.end()};
  std::vector<std::string> chosen = split_list("--stage", text);
  for (const std::string& name : chosen) parse_name("--stage", name, names);
  return chosen;
}

std::filesystem::path known_file(const MutateOptions& options) {
  if (!options.known.empty()) return options.known;
  const std::filesystem::path directory = std::filesystem::path(options.source) / "testbench/mutation";
  return directory / (options.model ? "model_survivors.json" : "survivors.json");
}

// Reasons are of stages, or of files of the model.
void check_known(const mutation::KnownSurvivors& known, const MutateOptions& options) {
  const std::vector<std::string_view> stages = stage_names();
  const std::vector<std::string> legal =
      options.model ? mutation::model_files(options.source) : std::vector<std::string>(stages.begin(), stages.end());
  for (const auto& [name, reasons] : known) {
    if (std::ranges::find(legal, name) != legal.end()) continue;
    bad_input(known_file(options).string(), options.model ? "file" : "stage", name,
              fmt::to_string(fmt::join(legal, ", ")));
  }
}

// And of mutants that there are.
template <typename Has>
void check_known(const std::string& name, const Has& has, const mutation::KnownSurvivors& known,
                 const MutateOptions& options) {
  const auto reasons = known.find(name);
  if (reasons == known.end()) return;
  for (const auto& [mutant, reason] : reasons->second) {
    if (!has(mutant)) bad_input(known_file(options).string(), name, mutant, "a mutant of it");
  }
}

// Wrong reasons are told before the work.
std::vector<mutation::StageMutants> prepare_stages(const std::vector<std::string>& names, const MutateOptions& options,
                                                   const mutation::Workshop& workshop,
                                                   const mutation::KnownSurvivors& known) {
  std::vector<mutation::StageMutants> stages;
  for (const std::string& name : names) {
    std::filesystem::create_directories(workshop.directory / name);
    stages.emplace_back(name, workshop.source, workshop.directory / name);
    check_known(
        name, [&](const std::string& mutant) { return stages.back().has(mutant); }, known, options);
  }
  return stages;
}

std::vector<mutation::StageResult> run_model(const MutateOptions& options, const mutation::Workshop& workshop,
                                             const mutation::KnownSurvivors& known) {
  for (const auto& [file, names] : mutation::model_mutant_names(options.source)) {
    check_known(
        file, [&names = names](const std::string& mutant) { return names.contains(mutant); }, known, options);
  }
  std::vector<mutation::StageResult> results;
  for (mutation::FileFates& file : try_model(workshop)) {
    results.push_back(judge(file.file, file.sites, std::move(file.fates), known));
  }
  return results;
}

mutation::StageResult run_stage(const mutation::StageMutants& stage, const MutateOptions& options,
                                const mutation::Workshop& workshop, const mutation::KnownSurvivors& known) {
  std::vector<mutation::Fate> fates;
  for (const mutation::Mutant& mutant : mutation::draw_mutants(stage.sites(), options.count, options.seed)) {
    fates.push_back({mutant, stage.describe(mutant)});
  }
  // What takes least time comes first.
  try_mutants(stage, {"smoke"}, workshop, fates);
  try_leaves(stage, true, workshop, fates);
  prove_registers(stage, workshop, fates);
  compare_logic(stage, mutation::Fate::Logic::kSame, workshop, fates);
  try_mutants(stage, {"close", "pace", "suite"}, workshop, fates);
  if (stage.stage() == mutation::kUnitName) {
    prove_ports(stage, workshop, fates);  // the unit is too large to say what nobody sees of it
  } else {
    compare_logic(stage, mutation::Fate::Logic::kUnobserved, workshop, fates);
  }
  try_leaves(stage, false, workshop, fates);
  try_mutants(stage, {"long"}, workshop, fates);
  return judge(stage.stage(), stage.sites().size(), std::move(fates), known);
}

mutation::StageResult run_roms(const mutation::StageMutants& stage, const mutation::Workshop& workshop,
                               const mutation::KnownSurvivors& known) {
  std::vector<mutation::Fate> fates;
  for (const mutation::Mutant& mutant : mutation::rom_mutants(stage.roms())) {
    fates.push_back({mutant, stage.describe(mutant)});
  }
  try_mutants(stage, {"smoke"}, workshop, fates);
  // Trials find soon what is wrong of a word that is read; of one that nothing reads they last to their end. To ask SAT
  // of one that is read takes long in arithmetic, of which pipelines are made.
  const auto prove = [&] { compare_logic(stage, mutation::Fate::Logic::kUnobserved, workshop, fates); };
  if (!is_pipeline(stage)) prove();
  try_mutants(stage, {"pace", "suite"}, workshop, fates);
  if (is_pipeline(stage)) prove();
  try_mutants(stage, {"close", "long"}, workshop, fates);
  return judge(stage.stage(), stage.sites().size(), std::move(fates), known);
}

int run_mutate(const MutateOptions& options) {
  const std::vector<std::string> stages = chosen_stages(options.stages);
  const std::filesystem::path directory = std::filesystem::absolute(options.output);
  mutation::check_source(options.source);
  const mutation::KnownSurvivors known = mutation::read_known_survivors(known_file(options));
  check_known(known, options);
  prepare_directory(options.output, {"mutation.json", "mutation.md"});
  const mutation::Workshop workshop(options.source, directory);
  std::vector<mutation::StageResult> results;
  if (options.model) {
    results = run_model(options, workshop, known);
  } else {
    for (const mutation::StageMutants& stage : prepare_stages(stages, options, workshop, known)) {
      results.push_back(options.roms ? run_roms(stage, workshop, known) : run_stage(stage, options, workshop, known));
    }
  }
  const std::vector<std::string> tiers =
      options.model ? std::vector<std::string>{"smoke", "unit", "tests", "leaves"}
                    : std::vector<std::string>{"smoke", mutation::kExhaustive, "close", "pace", "suite", "long"};
  const bool all = options.roms || options.model;
  const std::string json = to_json(results, all ? std::nullopt : std::optional(options.seed)).dump(1) + "\n";
  const std::string text = to_text(results, tiers);
  OutputFiles outputs;
  outputs.write(directory / "mutation.json", json);
  outputs.write(directory / "mutation.md", text);
  outputs.commit();
  fmt::print("{}", options.json ? json : text);
  for (const mutation::StageResult& result : results) {
    if (!result.open.empty() || !result.stale.empty()) return kBroken;
  }
  return kHolds;
}

}  // namespace

void add_mutate(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<MutateOptions>();
  CLI::App* command =
      program.add_subcommand("mutate", "breaks the RTL in thousands of places, one at a time, and sees what notices");
  command->footer(
      "A mutant is a bit of an operator's port, inverted, stuck, or inverted by another bit, as in Yosys' mutate; one\n"
      "build of a stage runs all of its mutants. Those that the first trial does not kill are tried over the domains\n"
      "of the stage's leaves (feline prove) and compared with the stage by SAT (Debian packages yosys and cadical);\n"
      "what is neither killed nor proved the same must be in testbench/mutation/survivors.json with a reason, or the\n"
      "exit code is 1, as for a reason of one that is killed, proved, or called equivalent against what SAT finds.\n"
      "Goes on where it was stopped. Those of the model are tried on the model's tests and the leaves, and what is\n"
      "left must be in model_survivors.json beside it.\n"
      "Example: feline mutate --stage walk,plan --count 2000 --output mutants");
  CLI::Option* const stage = command
                                 ->add_option("--stage", options->stages,
                                              fmt::format("{}; a list a,b, or all", fmt::join(stage_names(), ", ")))
                                 ->capture_default_str();
  CLI::Option* const count =
      command->add_option("--count", options->count, "mutants of each stage, or as many as there are")
          ->check(whole_number(1, 1000000))
          ->capture_default_str();
  CLI::Option* const seed = command->add_option("--seed", options->seed, "of the choice of mutants")
                                ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
                                ->capture_default_str();
  CLI::Option* const roms =
      command->add_flag("--roms", options->roms, "instead every bit of every ROM of the stage")->excludes(count, seed);
  command
      ->add_flag("--model", options->model,
                 "instead the model's sources: every operator, condition, number and value, against exact arithmetic")
      ->excludes(stage, count, seed, roms);
  command->add_option("--known", options->known, "survivors with reasons, instead of the sources' own");
  command->add_option("--source", options->source, "the project's sources")->capture_default_str();
  command->add_option("--output", options->output, "directory for mutants, builds, mutation.json and mutation.md")
      ->capture_default_str();
  command->add_flag("--json", options->json, "the result as JSON");
  command->callback([options, &exit_code] { exit_code = run_mutate(*options); });
}

}  // namespace feline
