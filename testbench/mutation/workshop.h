// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "testbench/measure/cache.h"
#include "testbench/run_lock.h"

namespace feline::mutation {

// Throws InputError naming `--source` for other sources than this project's.
void check_source(const std::filesystem::path& source);

// Where mutants are built, and what is known from before. Its results follow from the sources, whatever build of this
// program makes them.
struct Workshop {
  // Of checked sources. Throws InputError when a tool is not there, or while another run has the directory.
  Workshop(const std::filesystem::path& source, const std::filesystem::path& directory);

  std::filesystem::path source;     // of the project
  std::filesystem::path directory;  // of all stages
  RunLock lock;
  Cache cache;
  std::string trials;  // a hash of what the programs that try mutants are built from
  std::string proofs;  // and of what proves them the same, or finds them on leaves
};

// What a program writes, given `input`. Throws std::runtime_error when it fails.
std::string run_program(const std::vector<std::string>& command, const std::string& input = "");

// What a program that tries mutants writes. Throws WitnessMismatch, too, when it ends with exit code 1: what has no
// mutant is wrong already.
std::string run_trials(const std::vector<std::string>& command, const std::string& input = "");

}  // namespace feline::mutation
