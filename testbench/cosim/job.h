// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "testbench/cosim/cosimulation.h"
#include "testbench/picture.h"
#include "testbench/progress.h"

namespace feline {

// One co-simulation: a name for messages, batches made on demand, and the command line that makes it again.
struct CosimJob {
  std::string scene;
  std::string mode, kernel, wrap;
  Timing timing;
  std::string command;  // "feline cosim ..." without --replay
  int width = 0;        // of the picture; 0 for random lookups
  std::uint64_t lookups = 0;
  std::uint64_t batch_lookups = 0;  // in each batch but the last
  std::function<Batch(std::uint64_t batch)> batch;
};

struct CosimResult {
  std::uint64_t lookups = 0;
  std::uint64_t probes = 0;
  std::array<std::uint64_t, kStageCount> beats{};
  std::uint64_t mismatches = 0;
  std::uint64_t cycles = 0;
  std::uint64_t resets = 0;
  std::uint64_t memory_reads = 0;
  double seconds = 0;
  std::string message;  // what to tell about a mismatch
  std::vector<AccumulateBeat<kUnit>> pixels;
};

// Lookups first .. last of a run, instead of all.
struct ReplayRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

// How a mismatch is followed up.
struct FollowUp {
  RtlFactory trace;            // makes units with waveforms; none: no waveform
  std::filesystem::path wave;  // where the waveform goes
};

// Runs a job to its end or its first mismatch. After a mismatch it runs again: the lookup alone, to see whether that
// is enough, and whatever is needed once more with a waveform open around the mismatch.
CosimResult run_job(const CosimJob& job, const RtlFactory& factory, const FollowUp& follow_up,
                    const std::optional<ReplayRange>& replay, bool keep_pixels, Progress* progress);

// Field by field, hex and real value, with the inputs of the stage that is wrong. Ends with a newline.
std::string describe_mismatch(const Mismatch& mismatch, const CosimJob& job);

}  // namespace feline
