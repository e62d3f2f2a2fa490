// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/steady_flow.h"

#include <string>

namespace feline::mutation {

bool moves_by_itself(const Aiger& aiger) {
  std::vector<bool> is_seen(aiger.first_gate() + aiger.gates.size());
  std::vector<std::uint32_t> open;
  const auto look_at = [&](std::uint32_t literal) {
    if (is_seen[literal / 2]) return;
    is_seen[literal / 2] = true;
    open.push_back(literal / 2);
  };
  for (const Aiger::Output& output : aiger.outputs) {
    if (output.name.ends_with("_valid_o") || output.name.ends_with("_ready_o")) look_at(output.literal);
  }
  while (!open.empty()) {
    const std::uint32_t variable = open.back();
    open.pop_back();
    if (variable >= aiger.first_gate()) {
      const Aiger::Gate& gate = aiger.gates[variable - aiger.first_gate()];
      look_at(gate.left);
      look_at(gate.right);
    } else if (variable >= aiger.first_latch()) {
      look_at(aiger.next[variable - aiger.first_latch()]);
    } else if (variable > 0) {
      const std::string& name = aiger.inputs[variable - 1];
      if (name != "rst_i" && !name.ends_with("_valid_i") && !name.ends_with("_ready_i")) return false;
    }
  }
  return true;
}

SteadyRun::SteadyRun(const Aiger& aiger) : aiger_(aiger), given_{0}, state_(aiger.next.size(), 0) {
  for (std::uint32_t i = 0; i < aiger.inputs.size(); ++i) {
    const std::string port = port_of(aiger.inputs[i]);
    const bool flows = port.ends_with("_valid_i") || port.ends_with("_ready_i");
    given_.push_back(port == "rst_i" ? 0 : flows ? 1 : 2 * (i + 1));
  }
}

void SteadyRun::step(HashedGates& gates) {
  variables_ = given_;
  variables_.insert(variables_.end(), state_.begin(), state_.end());
  variables_ = copy_gates(aiger_, std::move(variables_), gates);
  for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = moved(aiger_.next[i]);
}

std::uint32_t SteadyRun::legal() const {
  for (const Aiger::Output& output : aiger_.outputs) {
    if (output.name == "legal_o") return moved(output.literal);
  }
  return 1;
}

bool SteadyRun::comes_out() const {
  return legal() != 0 && std::ranges::all_of(aiger_.outputs, [&](const Aiger::Output& output) {
           return !output.name.ends_with("_valid_o") || moved(output.literal) == 1;
         });
}

SteadyPair::SteadyPair(const Aiger& right, const Aiger& wrong)
    : both_{right.inputs, {}, {}, {}}, gates_(both_), right_(right), wrong_(wrong), outputs_(right.outputs.size()) {}

void SteadyPair::step() {
  right_.step(gates_);
  wrong_.step(gates_);
  legal_ = gates_(legal_, right_.legal());
}

Aiger SteadyPair::with_output(std::uint32_t literal) {
  Aiger circuit = both_;
  circuit.outputs.push_back({circuit.add_gate(legal_, literal), ""});
  return circuit;
}

Aiger SteadyPair::registers_differ() {
  std::uint32_t differs = 0;
  for (std::size_t i = 0; i < right_.state().size(); ++i) {
    differs = gates_.either(differs, gates_.different(right_.state()[i], wrong_.state()[i]));
  }
  return with_output(differs);
}

Aiger SteadyPair::outputs_differ() {
  std::uint32_t differs = 0;
  for (std::size_t i = 0; i < outputs_; ++i) {
    differs = gates_.either(differs, gates_.different(right_.output(i), wrong_.output(i)));
  }
  return with_output(differs);
}

}  // namespace feline::mutation
