// SPDX-License-Identifier: Apache-2.0
// feline_coverage: what the tests' stimuli reach of RTL, model and functional bins. Built and run by tests/coverage.sh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "testbench/atomic_file.h"
#include "testbench/coverage/coverage_page.h"
#include "testbench/coverage/model_points.h"
#include "testbench/coverage/rtl_points.h"
#include "testbench/coverage/suite.h"

namespace feline::coverage {
namespace {

struct Options {
  std::string output = "build/coverage";
  std::uint64_t seed = 1;
  std::string sources = ".";
  std::string model;
  std::string exclusions = "testbench/coverage/exclusions.txt";
  std::string ratchet = "testbench/coverage/ratchet.json";
  bool update = false;
};

int run(const Options& options) {
  const std::filesystem::path directory = options.output;
  const CoveredUnit covered = make_covered_unit(options.seed);
  const SuiteResult result = run_suite(covered, options.seed);
  if (!result.mismatch.empty()) {
    fmt::print(stderr, "{}", result.mismatch);
    return 1;
  }
  std::vector<BinGrid> grids = result.lookups.grids();
  grids.insert(grids.end(), result.stalls.grids().begin(), result.stalls.grids().end());
  AtomicFile rtl(directory / "rtl.dat");
  covered.write(rtl.temporary());
  rtl.commit();
  write_file_atomically(directory / "bins.json", to_json(grids).dump(1) + "\n");
  fmt::print("{} beats in {} cycles, every one the model's\n", result.beats, result.cycles);
  return 0;
}

int judge(const Options& options) {
  const std::filesystem::path directory = options.output;
  SourceText sources(options.sources);
  Coverage coverage;
  coverage.points = read_rtl_points(directory / "rtl.dat", sources);
  coverage.grids = read_bin_grids(directory / "bins.json");
  for (const auto& more : {read_model_points(options.model, sources), bin_points(coverage.grids)}) {
    coverage.points.insert(coverage.points.end(), more.begin(), more.end());
  }
  coverage.exclusions = read_exclusions(options.exclusions);
  coverage.faults = exclude(coverage.points, coverage.exclusions);
  if (!options.update) {
    const auto lost = losses(coverage.points, read_ratchet(options.ratchet));
    coverage.faults.insert(coverage.faults.end(), lost.begin(), lost.end());
  }
  OutputFiles outputs;
  outputs.write(directory / "coverage.html", coverage_page(coverage, sources));
  outputs.write(directory / "coverage.json", coverage_json(coverage).dump(1) + "\n");
  if (options.update && coverage.faults.empty()) {
    outputs.write(options.ratchet, to_json(ratchet_of(coverage.points)).dump(1) + "\n");
  }
  outputs.commit();
  fmt::print("{}", coverage_text(coverage));
  for (const std::string& fault : coverage.faults) fmt::print(stderr, "coverage: {}\n", fault);
  fmt::print("{0}/coverage.html\n{0}/coverage.json\n", directory.string());
  return coverage.faults.empty() ? 0 : 1;
}

int program(int argc, char** argv) {
  CLI::App app{
      "What the tests' stimuli reach. Exit codes: 0 all that they did before, 1 less or a mismatch, 2 bad input."};
  app.require_subcommand(1);
  Options options;
  CLI::App* run_command = app.add_subcommand("run", "runs the stimuli; writes rtl.dat and bins.json");
  CLI::App* judge_command = app.add_subcommand("judge", "reads them and the model's counts; writes page and JSON");
  for (CLI::App* command : {run_command, judge_command}) {
    command->add_option("--output", options.output, "directory")->capture_default_str();
  }
  run_command->add_option("--seed", options.seed, "of the stimuli")->capture_default_str();
  judge_command->add_option("--sources", options.sources, "the sources' root")->capture_default_str();
  judge_command->add_option("--model", options.model, "what llvm-cov show prints")->required();
  judge_command->add_option("--exclusions", options.exclusions, "what nothing can reach")->capture_default_str();
  judge_command->add_option("--ratchet", options.ratchet, "what was reached before")->capture_default_str();
  judge_command->add_flag("--update", options.update, "write the ratchet anew");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  remove_temporaries_when_killed();
  return run_command->parsed() ? run(options) : judge(options);
}

}  // namespace
}  // namespace feline::coverage

int main(int argc, char** argv) {
  try {
    return feline::coverage::program(argc, argv);
  } catch (const std::exception& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return 2;
  }
}
