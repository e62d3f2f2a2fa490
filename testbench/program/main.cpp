// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

#include "testbench/atomic_file.h"
#include "testbench/program/commands.h"

namespace {

// Never throws, wherever standard error goes.
void complain(const std::string& what) { std::fputs(("feline: " + what + "\n").c_str(), stderr); }

int run(const std::vector<std::string>& arguments, int argc, char** argv) {
  CLI::App program{"Feline: an anisotropic texture unit, its bit-accurate model and their co-simulation."};
  program.require_subcommand(1);
  program.footer(
      "Exit codes: 0 holds, 1 a mismatch or a broken bound, 2 bad use or bad input.\n"
      "Example: feline cosim --scene bricks --mode table --size 256");
  int exit_code = feline::kHolds;
  feline::add_commands(program, exit_code, arguments);
  feline::check_arguments(program, arguments);
  feline::remove_temporaries_when_killed();
  try {
    program.parse(argc, argv);
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error.what());
    return feline::kBadInput;
  } catch (const std::system_error& error) {
    // Of what is written here only standard output goes through a library that throws this.
    complain(fmt::format("standard output: {}", error.what()));
    return feline::kBadInput;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      program.exit(error);
      if (std::cout.flush()) return feline::kHolds;
      complain("standard output: could not be written");
      return feline::kBadInput;
    }
    complain(fmt::format("command line: {}; --help tells what is legal", error.what()));
    return feline::kBadInput;
  }
  if (std::fflush(stdout) != 0) {
    complain(fmt::format("standard output: {}", std::strerror(errno)));
    return feline::kBadInput;
  }
  return exit_code;
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): only where there is no memory to say so
int main(int argc, char** argv) {
  // A file beyond the size limit is then a write error like any other, with a message.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run({argv, argv + argc}, argc, argv);
  } catch (const std::bad_alloc&) {
    complain("out of memory: smaller pictures and textures take less");
    return feline::kBadInput;
  } catch (const std::exception& error) {
    // Bad input, a stale build: never to be taken for a mismatch.
    complain(error.what());
    return feline::kBadInput;
  }
}
