// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/program.h"

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
#include "testbench/error.h"
#include "testbench/program/commands.h"

namespace feline {
namespace {

// Never throws, wherever standard error goes.
void complain(const std::string& what) { std::fputs(("feline: " + what + "\n").c_str(), stderr); }

int run(const std::vector<std::string>& arguments, int argc, char** argv) {
  CLI::App program{"Feline: an anisotropic texture unit, its bit-accurate model and their co-simulation."};
  program.require_subcommand(1);
  program.footer(
      "Exit codes: 0 holds, 1 a mismatch or a broken bound, 2 bad use or bad input.\n"
      "Example: feline cosim --scene bricks --mode table --size 256");
  int exit_code = kHolds;
  add_commands(program, exit_code, arguments);
  check_arguments(program, arguments);
  remove_temporaries_when_killed();
  try {
    program.parse(argc, argv);
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error.what());
    return kBadInput;
  } catch (const std::system_error& error) {
    // Of what is written here only standard output goes through a library that throws this.
    complain(fmt::format("standard output: {}", error.what()));
    return kBadInput;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      program.exit(error);
      if (std::cout.flush()) return kHolds;
      complain("standard output: could not be written");
      return kBadInput;
    }
    complain(fmt::format("command line: {}; --help tells what is legal", error.what()));
    return kBadInput;
  }
  if (std::fflush(stdout) != 0) {
    complain(fmt::format("standard output: {}", std::strerror(errno)));
    return kBadInput;
  }
  return exit_code;
}

}  // namespace

int run_program(int argc, char** argv) {
  // A file beyond the size limit is then a write error like any other, with a message.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run({argv, argv + argc}, argc, argv);
  } catch (const std::bad_alloc&) {
    complain("out of memory: smaller pictures and textures take less");
    return kBadInput;
  } catch (const WitnessMismatch& error) {
    complain(error.what());
    return kBroken;
  } catch (const std::exception& error) {
    // Bad input, a stale build: never to be taken for a mismatch.
    complain(error.what());
    return kBadInput;
  }
}

}  // namespace feline
