// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "testbench/cosim/job.h"

namespace feline {

// What co-simulation found, run by run and in all.
struct CosimSummary {
  struct Run {
    const CosimJob* job;
    const CosimResult* result;
  };
  std::vector<Run> runs;  // at least one
  double seconds = 0;     // wall time of all of them, which may have run side by side

  bool holds() const;
};

// A line a run, and one of totals.
std::string to_text(const CosimSummary& summary);
// scene, mode, kernel, wrap, seed, lookups, probes, beats by stage, mismatches, cycles, memory_reads, seconds: of all
// runs, with "runs" holding the same of each.
nlohmann::ordered_json to_json(const CosimSummary& summary);

}  // namespace feline
