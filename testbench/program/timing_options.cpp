// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/timing_options.h"

#include <limits>

#include "testbench/program/command_line.h"

namespace feline {

TimingOptions add_timing(CLI::App& command, Timing& timing, const std::string& seeded) {
  TimingOptions options{};
  options.memory_latency =
      command.add_option("--memory-latency", timing.memory_latency, "cycles from a read to its data")
          ->check(whole_number(0, 100000))
          ->capture_default_str();
  options.stalls = command.add_option("--stalls", timing.stalls, "chance of a stall at each port in each cycle")
                       ->check(number(0, 0.95))
                       ->capture_default_str();
  command.add_option("--seed", timing.seed, "of " + seeded)
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  return options;
}

}  // namespace feline
