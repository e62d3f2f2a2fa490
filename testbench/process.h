// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace feline {

struct Finished {
  int code = 0;  // exit code; 128 + the signal that ended it
  std::string output;
  std::string errors;
};

// Runs a program that is found on the PATH, `input` on its standard input, and waits for its end. A program that does
// not read all of it is no error. Throws std::system_error when it cannot be started, ENOENT where there is none.
Finished run_process(const std::vector<std::string>& command, std::string_view input);

}  // namespace feline
