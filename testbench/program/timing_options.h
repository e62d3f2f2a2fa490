// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "testbench/cosim/cosimulation.h"

namespace feline {

// --memory-latency, --stalls and --seed, which help says is of `seeded`.
struct TimingOptions {
  CLI::Option* memory_latency;
  CLI::Option* stalls;
};
TimingOptions add_timing(CLI::App& command, Timing& timing, const std::string& seeded);

}  // namespace feline
