// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline {

// The program as a user calls it.
inline Outcome run(const std::string& arguments, const std::string& before = "") {
  return run_program(FELINE_PROGRAM, arguments, before);
}

// A path for the shell.
inline std::string quoted_path(const TempDir& dir, const std::string& name) {
  return "'" + (dir / name).string() + "'";
}

// Wrong input: exit code 2, a message that holds all of `parts`, and nothing new in the directory.
inline void expect_refused(const TempDir& dir, const std::string& arguments, const std::vector<std::string>& parts,
                           const std::string& before = "") {
  const auto files = dir.file_count();
  const Outcome outcome = run(arguments, before);
  EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.text;
  for (const std::string& part : parts) {
    EXPECT_NE(outcome.text.find(part), std::string::npos) << arguments << ": no \"" << part << "\" in\n"
                                                          << outcome.text;
  }
  EXPECT_EQ(dir.file_count(), files) << arguments;
}

}  // namespace feline
