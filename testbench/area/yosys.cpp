// SPDX-License-Identifier: Apache-2.0
#include "testbench/area/yosys.h"

#include <fmt/format.h>

#include "testbench/error.h"
#include "testbench/tool.h"

namespace feline {
namespace {

constexpr std::string_view kPackage = "yosys";

}  // namespace

Finished run_yosys(const std::vector<std::string>& arguments, std::string_view needs_it) {
  std::vector<std::string> command{"yosys"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_tool(command, kPackage, needs_it);
}

Finished run_abc(const std::string& commands, std::string_view needs_it, std::optional<int> seconds) {
  std::vector<std::string> command{"yosys-abc", "-q", commands};
  // abc looks at its own limits in places only.
  if (!seconds) return run_tool(command, kPackage, needs_it);
  command.insert(command.begin(), {"timeout", std::to_string(*seconds)});
  Finished finished = run_tool(command, "coreutils", needs_it);
  constexpr int kNotFound = 127;  // of timeout
  if (finished.code == kNotFound)
    throw InputError(fmt::format("{}{} (Debian package {})", finished.errors, needs_it, kPackage));
  return finished;
}

std::string yosys_version(std::string_view needs_it) {
  const Finished told = run_yosys({"-V"}, needs_it);
  return told.output.substr(0, told.output.find(" ("));
}

}  // namespace feline
