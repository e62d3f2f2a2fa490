// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "testbench/coverage/covered_unit.h"
#include "testbench/coverage/lookup_bins.h"
#include "testbench/coverage/stall_bins.h"
#include "testbench/progress.h"

namespace feline::coverage {

struct SuiteResult {
  LookupBins lookups;
  StallBins stalls;
  std::uint64_t beats = 0;  // compared with the model's
  std::uint64_t cycles = 0;
  std::string mismatch;  // empty where RTL and model agree
};

// The tests' stimuli, fewer of each: random and directed lookups, scenes, the largest texture, lookups that the model
// picks because they reach a bin first, stalls of every length, resets at any cycle. Every beat is compared. Counts of
// the unit start anew once its registers hold what came through it.
SuiteResult run_suite(const CoveredUnit& covered, std::uint64_t seed);

}  // namespace feline::coverage
