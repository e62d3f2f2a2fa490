// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <memory>
#include <optional>

#include "testbench/atomic_file.h"
#include "testbench/budget/budget_report.h"
#include "testbench/budget/gates.h"
#include "testbench/error.h"
#include "testbench/page/gnuplot.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/exhibits.h"
#include "testbench/scenes/scene.h"

namespace feline {
namespace {

constexpr double kGreatestLoss = 1e9;
constexpr int kTimedRuns = 3;
constexpr const char* kSourceDirectory = FELINE_SOURCE_DIR;

struct BudgetOptions {
  ExhibitOptions exhibits{std::string(scenes().front().name), "128"};
  std::vector<double> decibels;
  std::vector<double> worst;
  std::string truth = "gaussian";
  std::string cost = "cycles";
  std::string space = "full";
  std::string kernel = "bilinear";
  std::string source = kSourceDirectory;
  std::string library = kCellLibrary;
  std::string output = "feline-budget";
  std::string cache;
  std::uint64_t seed = 1;
  bool json = false;
};

SearchOptions search_options(const BudgetOptions& options) {
  SearchOptions search;
  search.truth = static_cast<TruthChoice>(parse_name("--truth", options.truth, kTruthChoiceNames));
  search.cost = static_cast<CostKind>(parse_name("--cost", options.cost, kCostNames));
  search.kernel = static_cast<Kernel>(parse_name("--kernel", options.kernel, kKernelNames));
  search.survey.space = static_cast<Space>(parse_name("--space", options.space, kSpaceNames));
  search.survey.seed = options.seed;
  search.survey.runs = search.cost == CostKind::kNanoseconds ? kTimedRuns : 1;
  for (const double limit : options.decibels) search.budgets.push_back({Budget::Kind::kDecibels, limit});
  for (const double limit : options.worst) search.budgets.push_back({Budget::Kind::kWorst, limit});
  if (search.budgets.empty()) {
    for (const double limit : {0.1, 0.5, 1.0}) search.budgets.push_back({Budget::Kind::kDecibels, limit});
  }
  return search;
}

int run_budget(const BudgetOptions& options) {
  if (!kDefaultConfig.features.table_feline) {
    bad_input("tables/config.h", "features.table_feline", "false", "true, which budgets count from");
  }
  SearchOptions search = search_options(options);
  const std::vector<ExhibitPlan> plans = options.exhibits.plans();
  page::check_gnuplot();
  const std::filesystem::path directory = options.output;
  prepare_directory(options.output, {"budget.html", "budget.json", "budget.csv"});
  const Cache cache(options.cache.empty() ? directory / "cache" : std::filesystem::path(options.cache));
  std::optional<Synthesis> synthesis;
  if (search.cost == CostKind::kGates) {
    const std::filesystem::path rtl = std::filesystem::path(options.source) / "rtl";
    synthesis.emplace(options.library, &cache);
    unit_source(kDefaultConfig, rtl);  // complains before the work
    search.gates = synthesized_gates(*synthesis, rtl);
  }
  std::vector<SceneSearch> searches;
  {
    constexpr std::uint64_t kShare = 1000;
    Progress progress("searching", plans.size() * kShare);
    for (const ExhibitPlan& plan : plans) {
      Progress part(progress, kShare, search_work(search.cost));
      searches.push_back(search_scene(plan, search, cache, part));
    }
  }
  const nlohmann::ordered_json json = budget_json(searches, search);
  OutputFiles outputs;
  outputs.write(directory / "budget.html", budget_page(searches, search));
  outputs.write(directory / "budget.json", json.dump(1) + "\n");
  outputs.write(directory / "budget.csv", budget_csv(searches, search));
  outputs.commit();
  if (options.json) {
    fmt::print("{}\n", json.dump(1));
  } else {
    fmt::print("{}", budget_text(searches, search));
    fmt::print("{0}/budget.html\n{0}/budget.json\n{0}/budget.csv\n", directory.string());
  }
  return all_hold(searches) ? kHolds : kBroken;
}

}  // namespace

void add_budget(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<BudgetOptions>();
  CLI::App* command =
      program.add_subcommand("budget", "the cheapest configuration that keeps to an error budget, by measurement");
  command->footer(
      "Every candidate of the space is rendered and compared with the truth; the cheapest that holds the budget is\n"
      "measured anew. Exit code 1: that one does not hold, or none does. Gates need Yosys and cells, as feline area\n"
      "does, and take minutes for each unit that has to be synthesized.\n"
      "Example: feline budget --scene window --budget-db 0.1,0.5,1 --cost cycles");
  options->exhibits.add_to(*command);
  command
      ->add_option("--budget-db", options->decibels,
                   "PSNR that may be lost against the full unit in Table mode, dB; a list a,b. 0.1,0.5,1 by default")
      ->delimiter(',')
      ->check(number(0, kGreatestLoss));
  command->add_option("--budget-worst", options->worst, "error that the worst pixel may have, codes of 255; a list a,b")
      ->delimiter(',')
      ->check(number(0, 255));
  const auto names = [&](const char* option, std::string& value, const std::string& what, const auto& legal) {
    command->add_option(option, value, fmt::format("{}: {}", what, fmt::join(legal, ", ")))->capture_default_str();
  };
  names("--truth", options->truth, "what errors are against", kTruthChoiceNames);
  names("--cost", options->cost, "what is to be least", kCostNames);
  names("--space", options->space, "what is searched", kSpaceNames);
  names("--kernel", options->kernel, "the full unit's kernel", kKernelNames);
  command->add_option("--source", options->source, "this project's sources, for gates: with rtl/")
      ->capture_default_str();
  command->add_option("--library", options->library, "Liberty file of the cells, for gates")->capture_default_str();
  command->add_option("--output", options->output, "directory for budget.html, budget.json, budget.csv")
      ->capture_default_str();
  command->add_option("--cache", options->cache,
                      "directory of what is known already, so that a search goes on where it was stopped; cache in "
                      "--output by default. What another build left there is of no use: remove it");
  command->add_option("--seed", options->seed, "of the truth's samples")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print budget.json");
  command->callback([options, &exit_code] { exit_code = run_budget(*options); });
}

}  // namespace feline
