// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/sat.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "testbench/area/yosys.h"
#include "testbench/atomic_file.h"
#include "testbench/mutation/elaboration.h"
#include "testbench/text_file.h"

namespace feline::mutation {
namespace {

constexpr std::size_t kMostRegisters = 6;
constexpr std::string_view kSolverPackage = "cadical";

bool says(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

// What abc says in so many seconds. Throws std::runtime_error when it fails otherwise.
std::string ask_abc(const std::string& commands) {
  constexpr int kPatience = 20;
  const page::Finished finished = run_abc(commands, kMutantsNeedIt, kPatience);
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

std::optional<bool> satisfiable(const Aiger& aiger) {
  constexpr int kPatience = 100;  // seconds
  constexpr int kSatisfiable = 10;
  constexpr int kUnsatisfiable = 20;
  const std::filesystem::path work = std::filesystem::temp_directory_path();
  const AtomicFile file(work / "feline-formula.aig");
  const AtomicFile clauses(work / "feline-formula.cnf");
  write_text(file.temporary(), to_binary(aiger));
  ask_abc(fmt::format("read_aiger {}; strash; write_cnf {}", file.temporary().string(), clauses.temporary().string()));
  const page::Finished finished =
      run_tool({"cadical", "-q", "-n", "-t", std::to_string(kPatience), clauses.temporary().string()}, kSolverPackage,
               kMutantsNeedIt);
  if (finished.code == kUnsatisfiable) return false;
  if (finished.code == kSatisfiable) return true;
  if (finished.code == 0) return std::nullopt;
  throw std::runtime_error(fmt::format("cadical: exit code {}\n{}{}", finished.code, finished.output, finished.errors));
}

std::string solver_version() { return run_tool({"cadical", "--version"}, kSolverPackage, kMutantsNeedIt).output; }

std::optional<bool> flows_otherwise(const Aiger& right, const Aiger& wrong) {
  if (!moves_by_itself(wrong)) return std::nullopt;
  const Aiger flow = steady_flow(right, kMostRegisters + 1);
  if (!comes_out(flow)) throw std::runtime_error("a stage of more registers than a pipeline may have");
  return satisfiable(difference(flow, steady_flow(wrong, kMostRegisters + 1)));
}

}  // namespace feline::mutation
