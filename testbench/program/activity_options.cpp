// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/activity_options.h"

#include <limits>

#include "testbench/error.h"
#include "testbench/program/command_line.h"

namespace feline {

void ActivityOptions::add_to(CLI::App& command) {
  frames.add_to(command);
  command.add_option("--memory-latency", timing.memory_latency, "cycles from a read to its data")
      ->check(whole_number(0, 100000))
      ->capture_default_str();
  command.add_option("--stalls", timing.stalls, "chance of a stall at each port in each cycle")
      ->check(number(0, 0.95))
      ->capture_default_str();
  command.add_option("--seed", timing.seed, "of stalls and power-up state")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
}

Activity ActivityOptions::measure() const {
  Activity activity;
  frames.for_each("counting toggles", [&](const Frame& frame, Progress& progress) {
    SamplerState<kUnit> sampler;
    try {
      sampler = make_sampler<kUnit>(frame.sampler, frame.texture, frame.memory);
    } catch (const SamplerError& error) {
      bad_input(frame.source, error.field, error.value, error.legal);
    }
    add(activity,
        measure_activity({sampler, &frame.memory, frame.gbuffer.lookups, 0}, timing, make_trace_unit, &progress));
  });
  return activity;
}

}  // namespace feline
