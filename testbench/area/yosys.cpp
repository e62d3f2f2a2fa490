// SPDX-License-Identifier: Apache-2.0
#include "testbench/area/yosys.h"

#include <fmt/format.h>

#include <system_error>

#include "testbench/error.h"

namespace feline {
namespace {

page::Finished run_tool(const std::vector<std::string>& command, std::string_view needs_it) {
  try {
    return page::run_process(command, "");
  } catch (const std::system_error& error) {
    throw InputError(
        fmt::format("{}: {}; {} (Debian package yosys)", command.front(), error.code().message(), needs_it));
  }
}

}  // namespace

page::Finished run_yosys(const std::vector<std::string>& arguments, std::string_view needs_it) {
  std::vector<std::string> command{"yosys"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_tool(command, needs_it);
}

page::Finished run_abc(const std::string& commands, std::string_view needs_it) {
  return run_tool({"yosys-abc", "-q", commands}, needs_it);
}

std::string yosys_version(std::string_view needs_it) {
  const page::Finished told = run_yosys({"-V"}, needs_it);
  return told.output.substr(0, told.output.find(" ("));
}

}  // namespace feline
