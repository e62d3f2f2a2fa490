// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace feline {

// Exit codes of the program, which scripts rely on.
enum ExitCode : int {
  kHolds = 0,     // everything asked for holds
  kBroken = 1,    // RTL and model differ, or a bound is broken
  kBadInput = 2,  // bad use or bad input
};

// Each adds its subcommand, which sets the exit code when it runs.
void add_tables(CLI::App& program, int& exit_code);
void add_scene(CLI::App& program, int& exit_code);
void add_explain(CLI::App& program, int& exit_code);
void add_stability(CLI::App& program, int& exit_code);
void add_vectors(CLI::App& program, int& exit_code);
void add_report(CLI::App& program, int& exit_code);
void add_figure(CLI::App& program, int& exit_code);
void add_area(CLI::App& program, int& exit_code);
void add_shortcuts(CLI::App& program, int& exit_code);
void add_savings(CLI::App& program, int& exit_code);
void add_profile(CLI::App& program, int& exit_code);
void add_budget(CLI::App& program, int& exit_code);
void add_mutate(CLI::App& program, int& exit_code);
void add_prove(CLI::App& program, int& exit_code);
// `arguments` is the whole command line, from which further commands are made.
void add_render(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments);
void add_activity(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments);
void add_prune(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments);
void add_cosim(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments);

// All of them.
void add_commands(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments);
// Throws InputError for a command line that names no command of the program, or has an empty value.
void check_arguments(const CLI::App& program, const std::vector<std::string>& arguments);

}  // namespace feline
