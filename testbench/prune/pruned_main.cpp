// SPDX-License-Identifier: Apache-2.0
// feline_pruned: the check of a pruned unit on frames. Built by testbench/prune/build.sh, run by `feline prune`.
#include <fmt/format.h>

#include <cstdio>

#include "testbench/program/frames.h"
#include "testbench/prune/check.h"

namespace {

int run(int argc, char** argv) {
  CLI::App program{"The check of a pruned unit: RTL, its model, and the full unit's pixels. Prints JSON."};
  feline::FrameOptions frames;
  frames.add_to(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  if (!frames.given()) frames.choose_default_scene();
  feline::PrunedCheck check;
  frames.for_each("checking", [&](const feline::Frame& frame, feline::Progress& progress) {
    feline::add(check, feline::check_pruned(frame.source, frame.gbuffer, frame.sampler, frame.texture, frame.memory,
                                            &progress));
  });
  fmt::print("{}\n", feline::to_json(check).dump(1));
  return check.holds() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fputs(("feline_pruned: " + std::string(error.what()) + "\n").c_str(), stderr);
    return 2;
  }
}
