// SPDX-License-Identifier: Apache-2.0
#include "testbench/tool.h"

#include <fmt/format.h>

#include <system_error>

#include "testbench/error.h"

namespace feline {

Finished run_tool(const std::vector<std::string>& command, std::string_view package, std::string_view needs_it) {
  try {
    return run_process(command, "");
  } catch (const std::system_error& error) {
    throw InputError(
        fmt::format("{}: {}; {} (Debian package {})", command.front(), error.code().message(), needs_it, package));
  }
}

}  // namespace feline
