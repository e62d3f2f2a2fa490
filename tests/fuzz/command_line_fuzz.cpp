// SPDX-License-Identifier: Apache-2.0
// The whole command line, one argument a line: taken or refused with a message, and numbers are what they look like.
// No command runs.
#include <CLI/CLI.hpp>
#include <charconv>
#include <functional>
#include <utility>

#include "testbench/program/commands.h"
#include "tests/fuzz/fuzz.h"

namespace feline {
namespace {

std::vector<std::string> arguments_of(fuzz::Input input) {
  std::vector<std::string> arguments{"feline"};
  while (!input.rest().empty()) {
    std::string argument(input.part('\n'));
    std::erase(argument, '\0');  // which no process gets
    arguments.push_back(std::move(argument));
  }
  return arguments;
}

void check_numbers(const CLI::App& command) {
  for (const CLI::Option* const option : command.get_options()) {
    const std::string type = option->get_type_name();
    if (!type.starts_with("INT") && !type.starts_with("UINT")) continue;
    for (const std::string& text : option->results()) {
      std::uint64_t meant = 0;
      std::uint64_t taken = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), meant);
      fuzz::require(error == std::errc{} && end == text.data() + text.size(), "an option's whole number is decimal");
      fuzz::require(CLI::detail::lexical_cast(text, taken) && taken == meant, "CLI11 takes it for that number");
    }
  }
}

// With everything but what commands do.
struct Program {
  CLI::App app{"Feline"};
  int exit_code = kHolds;
  // What a command's options are bound to lives in what it would do.
  std::vector<std::function<void()>> owners;

  Program() {
    struct Access : CLI::App {
      using CLI::App::final_callback_;
    };
    app.require_subcommand(1);
    add_commands(app, exit_code, {"feline"});
    for (CLI::App* const command : app.get_subcommands(nullptr)) {
      owners.push_back(std::exchange(command->*(&Access::final_callback_), nullptr));
      fuzz::require(owners.back() != nullptr, "a command does something");
    }
  }
};

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  // One for all inputs: CLI11 forgets what it parsed before, and making it takes a hundred times as long as parsing.
  static Program program;
  const std::vector<std::string> arguments = arguments_of(input);
  std::vector<const char*> pointers;
  for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
  accepts([&] {
    check_arguments(program.app, arguments);
    try {
      program.app.parse(static_cast<int>(pointers.size()), pointers.data());
      require(!program.app.get_subcommands().empty(), "a command is chosen");
      for (const CLI::App* const command : program.app.get_subcommands()) check_numbers(*command);
    } catch (const CLI::ParseError& error) {
      require(error.get_exit_code() == 0 || !std::string(error.what()).empty(), "a refusal says why");
    }
  });
}
