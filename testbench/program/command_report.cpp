// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "testbench/error.h"
#include "testbench/measure/survey.h"
#include "testbench/page/gnuplot.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/exhibits.h"
#include "testbench/report/report.h"

namespace feline {
namespace {

struct ReportOptions {
  ExhibitOptions exhibits{"all", "512"};
  std::string filters = "all";
  std::string output = "feline-report";
  std::string cache;
  std::optional<double> budget;
  std::uint64_t seed = 1;
  bool json = false;
};

std::vector<const Contestant*> choose_contestants(const std::string& text) {
  std::vector<const Contestant*> chosen;
  if (text == "all") {
    for (const Contestant& contestant : contestants()) chosen.push_back(&contestant);
    return chosen;
  }
  for (const std::string& name : split_list("--filter", text)) {
    const Contestant* const found = find_contestant(name);
    if (found == nullptr) bad_input("command line", "--filter", name, "all, or a list of " + contestant_names());
    chosen.push_back(found);
  }
  return chosen;
}

int run_report(const ReportOptions& options) {
  SurveyOptions survey_options;
  survey_options.contestants = choose_contestants(options.filters);
  survey_options.exhibits = options.exhibits.plans();
  survey_options.budget = options.budget;
  survey_options.seed = options.seed;
  page::check_gnuplot();
  const std::filesystem::path directory = options.output;
  prepare_directory(options.output, {"report.html", "report.json", "report.csv"});
  const Cache cache(options.cache.empty() ? directory / "cache" : std::filesystem::path(options.cache));
  const Survey survey = run_survey(survey_options, cache);
  const Report report = make_report(survey);
  OutputFiles outputs;
  outputs.write(directory / "report.html", report.html);
  outputs.write(directory / "report.json", report.json.dump(1) + "\n");
  outputs.write(directory / "report.csv", report.csv);
  outputs.commit();
  if (options.json) {
    fmt::print("{}\n", report.json.dump(1));
  } else {
    fmt::print("{}", report.text);
    fmt::print("{0}/report.html\n{0}/report.json\n{0}/report.csv\n", directory.string());
  }
  return report.holds ? kHolds : kBroken;
}

}  // namespace

void add_report(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand("report", "error against run time: all filters, all scenes");
  command->footer("Example: feline report --scene window --filter trilinear,ewa,unit_table --size 256");
  options->exhibits.add_to(*command);
  command->add_option("--filter", options->filters, contestant_names() + "; a list a,b, or all")->capture_default_str();
  command->add_option("--output", options->output, "directory for report.html, report.json, report.csv")
      ->capture_default_str();
  command->add_option("--cache", options->cache,
                      "directory of what is known already, so that a report goes on where it was stopped; cache in "
                      "--output by default. What another build left there is of no use: remove it");
  command->add_option("--budget", options->budget, "seconds after which nothing new is begun")->check(number(0, 1e9));
  command->add_option("--seed", options->seed, "of the ground truth's samples")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print report.json");
  command->callback([options, &exit_code] { exit_code = run_report(*options); });
}

}  // namespace feline
