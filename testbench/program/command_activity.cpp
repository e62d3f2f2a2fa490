// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <limits>
#include <memory>

#include "testbench/area/activity.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/frames.h"

namespace feline {
namespace {

struct ActivityOptions {
  FrameOptions frames;
  Timing timing;
  bool json = false;
};

int run_activity(const ActivityOptions& options) {
  options.frames.check();
  Activity activity;
  options.frames.for_each("counting toggles", [&](const Frame& frame, Progress& progress) {
    const auto sampler = prepare_sampler(frame.sampler, frame.texture, frame.memory);
    add(activity, measure_activity({sampler, &frame.memory, frame.gbuffer.lookups, 0}, options.timing, make_trace_unit,
                                   &progress));
  });
  fmt::print("{}", options.json ? to_json(activity).dump(1) + "\n" : to_text(activity));
  return kHolds;
}

}  // namespace

void add_activity(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ActivityOptions>();
  CLI::App* command = program.add_subcommand("activity", "toggles a pixel of every stage of the RTL, and cycles");
  command->footer(
      "Counts bits that change from one cycle to the next: of flip-flops, of all signals that a stage drives, and of the\n"
      "words of the texel cache. Example: feline activity --scene bricks --size 64 --memory-latency 100");
  options->frames.add_to(*command);
  command->add_option("--memory-latency", options->timing.memory_latency, "cycles from a read to its data")
      ->check(whole_number(1, 100000))
      ->capture_default_str();
  command->add_option("--stalls", options->timing.stalls, "chance of a stall at each port in each cycle")
      ->check(number(0, 0.95))
      ->capture_default_str();
  command->add_option("--seed", options->timing.seed, "of stalls and power-up state")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  command->add_flag("--json", options->json, "toggles of the whole run as JSON");
  command->callback([options, &exit_code] {
    if (!options->frames.given()) options->frames.choose_default_scene();
    exit_code = run_activity(*options);
  });
}

}  // namespace feline
