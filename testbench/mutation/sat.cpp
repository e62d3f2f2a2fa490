// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/sat.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "testbench/atomic_file.h"
#include "testbench/page/process.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

constexpr std::size_t kMostRegisters = 6;

bool says(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

// What abc says; it looks at its own limit of time in places only. Throws std::runtime_error when it fails otherwise.
std::string ask_abc(const std::string& commands) {
  constexpr int kPatience = 20;    // seconds
  constexpr int kOutOfTime = 124;  // of timeout
  const std::vector<std::string> command{"timeout", std::to_string(kPatience), "yosys-abc", "-q", commands};
  const page::Finished finished = page::run_process(command, "");
  if (finished.code != 0 && finished.code != kOutOfTime) {
    throw std::runtime_error(
        fmt::format("yosys-abc: exit code {}\n{}{}", finished.code, finished.output, finished.errors));
  }
  return finished.output;
}

}  // namespace

bool same_logic(const Aiger& right, const Aiger& wrong) {
  const std::filesystem::path work = std::filesystem::temp_directory_path();
  const AtomicFile right_file(work / "feline-right.aig");
  const AtomicFile wrong_file(work / "feline-mutant.aig");
  write_text(right_file.temporary(), to_binary(cut_latches(right)));
  write_text(wrong_file.temporary(), to_binary(cut_latches(wrong)));
  return says(ask_abc(fmt::format("&r {}; &cec {}", right_file.temporary().string(), wrong_file.temporary().string())),
              "Networks are equivalent");
}

bool unobserved(const Aiger& right, const Aiger& wrong) {
  const Aiger miter = observed_difference(right, wrong);
  if (miter.outputs.front().literal == 0) return true;
  const AtomicFile file(std::filesystem::temp_directory_path() / "feline-difference.aig");
  write_text(file.temporary(), to_binary(miter));
  return says(ask_abc(fmt::format("read_aiger {}; strash; scleanup; scorr; pdr", file.temporary().string())),
              "Property proved");
}

std::optional<bool> flows_otherwise(const Aiger& right, const Aiger& wrong) {
  const Aiger flow = steady_flow(right, kMostRegisters + 1);
  if (!comes_out(flow)) throw std::runtime_error("a stage of more registers than a pipeline may have");
  const AtomicFile file(std::filesystem::temp_directory_path() / "feline-flow.aig");
  write_text(file.temporary(), to_binary(difference(flow, steady_flow(wrong, kMostRegisters + 1))));
  const std::string said = ask_abc(fmt::format("read_aiger {}; strash; dc2; fraig; iprove", file.temporary().string()));
  if (says(said, "UNSATISFIABLE")) return false;
  if (says(said, "SATISFIABLE")) return true;
  return std::nullopt;
}

}  // namespace feline::mutation
