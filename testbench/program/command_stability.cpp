// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/page/gnuplot.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/stability_report.h"
#include "testbench/stability/study_data.h"
#include "testbench/stability/study_page.h"

namespace feline {
namespace {

struct StabilityOptions {
  stability::StudyOptions study;
  std::string classes = "all";
  std::string output;
  bool json = false;
};

std::vector<const stability::CaseClass*> chosen(const std::string& names) {
  std::vector<const stability::CaseClass*> classes;
  if (names == "all") return classes;
  std::vector<std::string_view> legal;
  for (const stability::CaseClass& of : stability::case_classes()) legal.push_back(of.name);
  legal.emplace_back("all");
  for (const std::string& name : split_list("--class", names)) {
    const std::size_t index = parse_name("--class", name, legal);
    if (index == legal.size() - 1) bad_input("command line", "--class", names, "all alone, or names of classes");
    classes.push_back(&stability::case_classes()[index]);
  }
  return classes;
}

int run_stability(StabilityOptions options) {
  options.study.classes = chosen(options.classes);
  if (!options.output.empty()) {
    const std::filesystem::path directory = options.output;
    if (!std::filesystem::is_directory(directory)) {
      bad_input(options.output, "--output", "no directory", "a directory that exists");
    }
    check_writable(directory / "stability.html");
    page::check_gnuplot();
  }
  return report_stability(stability::run_study(options.study), options.output, options.json);
}

}  // namespace

int report_stability(const stability::Study& study, const std::filesystem::path& directory, bool as_json) {
  const std::string json = stability::to_json(study).dump(1) + "\n";
  if (!directory.empty()) {
    OutputFiles outputs;
    outputs.write(directory / "stability.json", json);
    outputs.write(directory / "stability.csv", stability::to_csv(study));
    outputs.write(directory / "stability-jumps.csv", stability::jumps_to_csv(study));
    outputs.write(directory / "stability.html", stability::to_html(study));
    outputs.commit();
  }
  fmt::print("{}", as_json ? json : stability::to_text(study));
  return study.broken().empty() ? kHolds : kBroken;
}

void add_stability(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command =
      program.add_subcommand("stability", "errors on stiff and extreme input, against 200 bits, and their bounds");
  command->footer(
      "Writes stability.html, stability.json, stability.csv and stability-jumps.csv; exit code 1 if a bound is "
      "broken.\n"
      "Example: feline stability --class condition,far --count 1000 --output /tmp");
  command->add_option("--class", options->classes, "classes of input, with a comma between, or all")
      ->capture_default_str();
  command->add_option("--count", options->study.count, "lookups a class")
      ->check(whole_number(1, 1000000))
      ->capture_default_str();
  command->add_option("--seed", options->study.seed, "of the lookups")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_option("--output", options->output, "directory for the page and its data");
  command->add_flag("--json", options->json, "the study as JSON");
  command->callback([options, &exit_code] { exit_code = run_stability(*options); });
}

}  // namespace feline
