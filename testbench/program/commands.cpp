// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "testbench/error.h"
#include "testbench/program/command_line.h"

namespace feline {

void add_commands(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments) {
  add_tables(program, exit_code);
  add_scene(program, exit_code);
  add_render(program, exit_code, arguments);
  add_explain(program, exit_code);
  add_vectors(program, exit_code);
  add_cosim(program, exit_code, arguments);
  add_report(program, exit_code);
  add_figure(program, exit_code);
  add_stability(program, exit_code);
  add_area(program, exit_code);
  add_activity(program, exit_code, arguments);
  add_shortcuts(program, exit_code);
  add_prune(program, exit_code, arguments);
  add_savings(program, exit_code);
  add_profile(program, exit_code);
  add_budget(program, exit_code);
  add_prove(program, exit_code);
  add_mutate(program, exit_code);
}

void check_arguments(const CLI::App& program, const std::vector<std::string>& arguments) {
  std::vector<std::string> names;
  for (const CLI::App* const command : program.get_subcommands(nullptr)) names.push_back(command->get_name());
  if (arguments.size() > 1 && !arguments[1].starts_with('-') && std::ranges::find(names, arguments[1]) == names.end()) {
    bad_input("command line", "command", arguments[1], fmt::format("one of {}", fmt::join(names, ", ")));
  }
  refuse_empty(arguments);
}

}  // namespace feline
