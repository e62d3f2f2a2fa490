// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/figures/figure.h"
#include "testbench/image.h"
#include "testbench/page/gnuplot.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/progress.h"

namespace feline {
namespace {

struct FigureCommand {
  std::string name;
  std::string output;
  int size = FigureOptions{}.size;
  bool list = false;
  bool json = false;
};

using Target = std::pair<const Figure*, std::filesystem::path>;

int list_figures(bool json) {
  nlohmann::ordered_json all;
  for (const Figure& figure : figures()) {
    all.push_back({{"figure", figure.name}, {"description", figure.description}, {"extension", figure.extension}});
    if (!json) fmt::print("{:<14}  {}\n", figure.name, figure.description);
  }
  if (json) fmt::print("{}\n", all.dump(1));
  return kHolds;
}

std::vector<Target> choose_targets(const FigureCommand& command) {
  std::vector<Target> targets;
  if (command.name == "all") {
    const std::filesystem::path directory = command.output.empty() ? "." : command.output;
    if (!std::filesystem::is_directory(directory)) {
      bad_input(directory.string(), "--output", "no directory", "a directory that exists");
    }
    for (const Figure& figure : figures()) targets.emplace_back(&figure, directory / (figure.name + figure.extension));
    return targets;
  }
  const Figure& figure = find_figure(command.name);
  const std::filesystem::path path = command.output.empty() ? figure.name + figure.extension : command.output;
  const std::string extension = path.extension().string();
  if (!extension.empty() && extension != figure.extension) {
    bad_input(path.string(), "--output", extension, fmt::format("a {} file for {}", figure.extension, figure.name));
  }
  targets.emplace_back(&figure, path);
  return targets;
}

int run_figure(const FigureCommand& command) {
  if (command.list) return list_figures(command.json);
  if (command.name.empty()) bad_input("command line", "figure", "no name", "one of feline figure --list, or all");
  const std::vector<Target> targets = choose_targets(command);
  for (const auto& [figure, path] : targets) check_writable(path);
  page::check_gnuplot();
  Progress progress("drawing", targets.size());
  OutputFiles outputs;
  nlohmann::ordered_json all;
  for (const auto& [figure, path] : targets) {
    const FigureOutput made = figure->make({command.size});
    outputs.write(path, made.content);
    nlohmann::ordered_json entry{{"figure", figure->name}, {"file", path.string()}};
    entry.update(made.facts);
    all.push_back(std::move(entry));
    progress.advance(1);
  }
  outputs.commit();
  if (command.json) {
    fmt::print("{}\n", (command.name == "all" ? all : all.front()).dump(1));
  } else {
    for (const auto& [figure, path] : targets) fmt::print("{}\n", path.string());
  }
  return kHolds;
}

}  // namespace

void add_figure(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<FigureCommand>();
  CLI::App* command = program.add_subcommand("figure", "makes a figure of the papers again, by this project's filters");
  command->footer("Example: feline figure feline_35 --output feline_35.svg");
  auto* const name = command->add_option("name", options->name, "a figure's name, or all");
  auto* const output =
      command->add_option("--output", options->output, "file to write, NAME.svg if not given; a directory for all");
  auto* const size = command->add_option("--size", options->size, "pixels a side of each picture within")
                         ->check(whole_number(8, 2048))
                         ->capture_default_str();
  command->add_flag("--list", options->list, "tell the figures and stop")
      ->excludes(name)
      ->excludes(output)
      ->excludes(size);
  command->add_flag("--json", options->json, "tell what was written, and its figures in numbers, as JSON");
  command->callback([options, &exit_code] { exit_code = run_figure(*options); });
}

}  // namespace feline
