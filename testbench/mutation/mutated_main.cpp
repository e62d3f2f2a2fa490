// SPDX-License-Identifier: Apache-2.0
// feline_mutated: tries mutants of one stage. Built by testbench/mutation/build.sh, run by `feline mutate` with the
// names of tiers: codes of mutants on standard input, a line of JSON for each on standard output, in any order.
#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "testbench/error.h"
#include "testbench/mutation/trial.h"

namespace {

using namespace feline::mutation;

void tell(std::uint64_t code, const std::optional<Death>& death, std::mutex& mutex) {
  nlohmann::ordered_json line{{"code", code}};
  if (death) {
    line["tier"] = death->tier;
    line["stage"] = death->stage;
    line["lookup"] = death->lookup;
    line["cycles"] = death->cycles;
    line["milliseconds"] = death->milliseconds;
  }
  const std::scoped_lock lock(mutex);
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
}

void run(const std::vector<std::string>& names) {
  std::vector<std::uint64_t> codes;
  for (std::uint64_t code = 0; std::cin >> code;) codes.push_back(code);
  const Trial trial(tiers(names));
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < codes.size(); k = next++) tell(codes[k], trial.run(codes[k]), mutex);
    });
  }
  for (auto& thread : threads) thread.join();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run({argv + 1, argv + argc});
    return 0;
  } catch (const feline::WitnessMismatch& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return 1;
  } catch (const std::exception& error) {
    std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
    return 2;
  }
}
