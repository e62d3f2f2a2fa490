// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <memory>

#include "testbench/program/activity_options.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/unit_program.h"

namespace feline {
namespace {

struct ActivityCommand {
  ActivityOptions options;
  std::string unit;
  std::string source = FELINE_SOURCE_DIR;
  bool json = false;
  std::vector<std::string> arguments;  // of the command line, for a pruned unit's own program
};

int run_activity(const ActivityCommand& command) {
  command.options.frames.check();
  const Activity activity =
      command.unit.empty()
          ? command.options.measure()
          : activity_from_json(run_unit_program(command.source, command.unit, "feline_activity", command.arguments));
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
      "the words of the texel cache.\n"
      "Example: feline activity --scene bricks --size 64 --memory-latency 100");
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
