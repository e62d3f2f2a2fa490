// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/sat.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

#include "testbench/area/yosys.h"
#include "testbench/atomic_file.h"
#include "testbench/mutation/elaboration.h"
#include "testbench/mutation/steady_flow.h"
#include "testbench/text_file.h"
#include "testbench/tool.h"

namespace feline::mutation {
namespace {

constexpr std::size_t kMostRegisters = 6;
constexpr int kPatienceOfAbc = 20;  // seconds
constexpr int kPatience = 30;
constexpr std::string_view kSolverPackage = "cadical";

bool says(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

// What abc says in so many seconds. Throws std::runtime_error when it fails otherwise.
std::string ask_abc(const std::string& commands) {
  const Finished finished = run_abc(commands, kMutantsNeedIt, kPatienceOfAbc);
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

namespace {

// Clauses of the variables that the output depends on, as the AIGER file numbers them, in the DIMACS format.
std::string to_clauses(const Aiger& aiger) {
  const std::uint32_t output = aiger.outputs.front().literal;
  const auto variables = static_cast<std::uint32_t>(aiger.first_gate() + aiger.gates.size());
  // Variable 0, which is false, is the last one.
  const auto number = [&](std::uint32_t literal) {
    const auto variable = static_cast<std::int64_t>(literal < 2 ? variables : literal / 2);
    return (literal & 1) != 0 ? -variable : variable;
  };
  std::vector<bool> is_needed(variables);
  is_needed[output / 2] = true;
  std::size_t clauses = 2;
  std::string text;
  for (std::size_t i = aiger.gates.size(); i-- > 0;) {
    const auto own = static_cast<std::uint32_t>(2 * (aiger.first_gate() + i));
    if (!is_needed[own / 2]) continue;
    const auto [left, right] = aiger.gates[i];
    is_needed[left / 2] = is_needed[right / 2] = true;
    text += fmt::format("{0} {1} 0\n{0} {2} 0\n{3} {4} {5} 0\n", -number(own), number(left), number(right), number(own),
                        -number(left), -number(right));
    clauses += 3;
  }
  return fmt::format("p cnf {} {}\n{} 0\n{} 0\n", variables, clauses, -number(0), number(output)) + text;
}

// From lines "v 1 -2 ... 0".
std::vector<bool> inputs_from(const std::string& said, std::size_t count) {
  std::vector<bool> inputs(count);
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("v ")) continue;
    std::istringstream words(line.substr(2));
    for (std::int64_t word = 0; words >> word;) {
      if (word > 0 && static_cast<std::size_t>(word) <= count) inputs[static_cast<std::size_t>(word) - 1] = true;
    }
  }
  return inputs;
}

}  // namespace

Satisfied satisfy(const Aiger& aiger, int seconds) {
  using Answer = Satisfied::Answer;
  if (aiger.outputs.front().literal == 0) return {Answer::kNever, {}};
  constexpr int kSometimes = 10;
  constexpr int kNever = 20;
  const AtomicFile clauses(std::filesystem::temp_directory_path() / "feline-formula.cnf");
  write_text(clauses.temporary(), to_clauses(aiger));
  const Finished finished = run_tool({"cadical", "-q", "-t", std::to_string(seconds), clauses.temporary().string()},
                                     kSolverPackage, kMutantsNeedIt);
  if (finished.code == kNever) return {Answer::kNever, {}};
  if (finished.code == kSometimes) return {Answer::kSometimes, inputs_from(finished.output, aiger.inputs.size())};
  if (finished.code == 0) return {};
  throw std::runtime_error(fmt::format("cadical: exit code {}\n{}{}", finished.code, finished.output, finished.errors));
}

std::string solver_version() { return run_tool({"cadical", "--version"}, kSolverPackage, kMutantsNeedIt).output; }

Satisfied flows_otherwise(const Aiger& right, const Aiger& wrong) {
  using Answer = Satisfied::Answer;
  if (!moves_by_itself(wrong)) return {};
  SteadyPair pair(right, wrong);
  bool is_decided = true;
  for (std::size_t cycle = 0; cycle <= kMostRegisters; ++cycle) {
    pair.step();
    if (!is_decided) continue;
    // Where registers hold the same, all that follows from them is the same.
    const Answer differ = satisfy(pair.registers_differ(), kPatience).answer;
    is_decided = differ != Answer::kUndecided;
    if (differ == Answer::kNever) pair.make_same();
  }
  if (!pair.right().comes_out()) throw std::runtime_error("a stage of more registers than a pipeline may have");
  if (satisfy(pair.legal(), kPatience).answer != Answer::kSometimes) throw std::runtime_error("no beat is legal");
  return satisfy(pair.outputs_differ(), kPatience);
}

}  // namespace feline::mutation
