// SPDX-License-Identifier: Apache-2.0
// feline_activity: counts the toggles of a pruned unit. Built by testbench/prune/build.sh, run by `feline activity`.
#include <fmt/format.h>

#include <cstdio>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/program/activity_options.h"

namespace {

int run(int argc, char** argv) {
  CLI::App program{"The toggles of a pruned unit, stage by stage. Prints JSON."};
  feline::ActivityOptions options;
  options.add_to(program);
  feline::remove_temporaries_when_killed();
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  if (!options.frames.given()) options.frames.choose_default_scene();
  fmt::print("{}\n", feline::to_json(options.measure()).dump(1));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const feline::WitnessMismatch& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return 1;
  } catch (const std::exception& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return 2;
  }
}
