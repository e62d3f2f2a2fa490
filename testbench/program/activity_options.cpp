// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/activity_options.h"

#include "testbench/error.h"
#include "testbench/program/timing_options.h"

namespace feline {

void ActivityOptions::add_to(CLI::App& command) {
  frames.add_to(command);
  add_timing(command, timing, "stalls and power-up state");
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
