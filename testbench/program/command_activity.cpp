// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <memory>

#include "testbench/error.h"
#include "testbench/page/process.h"
#include "testbench/program/activity_options.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"

namespace feline {
namespace {

struct ActivityCommand {
  ActivityOptions options;
  std::string unit;
  std::string source = FELINE_SOURCE_DIR;
  bool json = false;
  std::vector<std::string> arguments;  // of the command line, for a pruned unit's own program
};

Activity of_pruned_unit(const ActivityCommand& command) {
  const std::filesystem::path directory = command.unit;
  const std::filesystem::path script = std::filesystem::path(command.source) / "testbench" / "prune" / "build.sh";
  if (!std::filesystem::exists(script)) {
    bad_input(command.source, "--source", "no testbench/prune/build.sh in it", "this project's sources");
  }
  if (!std::filesystem::exists(directory / "unit.h")) {
    bad_input(command.unit, "--unit", "no unit.h in it", "a directory of feline prune");
  }
  const page::Finished built = page::run_process({script.string(), directory.string(), "feline_activity"}, "");
  if (built.code != 0) throw std::runtime_error("the unit's build failed:\n" + built.output + built.errors);
  std::vector<std::string> program{std::filesystem::absolute(directory / "build" / "feline_activity").string()};
  program.insert(program.end(), command.arguments.begin(), command.arguments.end());
  const page::Finished finished = page::run_process(program, "");
  if (finished.code != 0) throw std::runtime_error("the pruned unit: " + finished.errors);
  return activity_from_json(nlohmann::ordered_json::parse(finished.output));
}

int run_activity(const ActivityCommand& command) {
  command.options.frames.check();
  const Activity activity = command.unit.empty() ? command.options.measure() : of_pruned_unit(command);
  fmt::print("{}", command.json ? to_json(activity).dump(1) + "\n" : to_text(activity));
  return kHolds;
}

}  // namespace

void add_activity(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments) {
  auto options = std::make_shared<ActivityCommand>();
  constexpr std::array<std::string_view, 2> kOptions{"--unit", "--source"};
  constexpr std::array<std::string_view, 1> kFlags{"--json"};
  constexpr std::size_t kProgramAndCommand = 2;
  if (arguments.size() > kProgramAndCommand) {
    options->arguments = arguments_without(std::span(arguments).subspan(kProgramAndCommand), {kOptions, kFlags});
  }
  CLI::App* command = program.add_subcommand("activity", "toggles a pixel of every stage of the RTL, and cycles");
  command->footer(
      "Counts bits that change from one cycle to the next: of flip-flops, of all signals that a stage drives, and of\n"
      "the words of the texel cache. Example: feline activity --scene bricks --size 64 --memory-latency 100");
  options->options.add_to(*command);
  command->add_option("--unit", options->unit,
                      "directory of feline prune, whose unit is built; otherwise the full unit");
  command->add_option("--source", options->source, "this project's sources, to build that from")->capture_default_str();
  command->add_flag("--json", options->json, "toggles of the whole run as JSON");
  command->callback([options, &exit_code] {
    if (!options->options.frames.given()) options->options.frames.choose_default_scene();
    exit_code = run_activity(*options);
  });
}

}  // namespace feline
