// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "testbench/area/toggles.h"
#include "testbench/cosim/cosimulation.h"
#include "testbench/progress.h"

namespace feline {

// What moves in the unit while it samples.
struct Activity {
  std::uint64_t lookups = 0;
  std::uint64_t probes = 0;
  std::uint64_t cycles = 0;
  std::vector<StageToggles> stages;
};

void add(Activity& into, const Activity& from);

// Co-simulates a batch on a unit with waveforms and counts toggles from the first request to the last pixel. Throws
// std::runtime_error when RTL and model differ. Takes some 30 microseconds and 1 kilobyte, in the directory of
// temporary files, a cycle.
Activity measure_activity(const Batch& batch, const Timing& timing, const RtlFactory& trace, Progress* progress);

nlohmann::ordered_json to_json(const Activity& activity);
std::string to_text(const Activity& activity);

}  // namespace feline
