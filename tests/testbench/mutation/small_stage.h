// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "testbench/mutation/aiger.h"

namespace feline::mutation {

// Runs logic a cycle at a time.
class Simulator {
 public:
  explicit Simulator(const Aiger& aiger) : aiger_(aiger), state_(aiger.next.size()) {}

  std::vector<bool> cycle(const std::vector<bool>& inputs) {
    std::vector<bool> values{false};
    values.insert(values.end(), inputs.begin(), inputs.end());
    values.insert(values.end(), state_.begin(), state_.end());
    const auto read = [&](std::uint32_t literal) { return values[literal / 2] != ((literal & 1) != 0); };
    for (const Aiger::Gate& gate : aiger_.gates) values.push_back(read(gate.left) && read(gate.right));
    for (std::size_t i = 0; i < state_.size(); ++i) state_[i] = read(aiger_.next[i]);
    std::vector<bool> outputs;
    for (const Aiger::Output& output : aiger_.outputs) outputs.push_back(read(output.literal));
    return outputs;
  }

 private:
  const Aiger& aiger_;
  std::vector<bool> state_;
};

// A register between two streams that is always ready; its data are taken when they are valid, or, being another,
// always; or inverted when mutant[1] is set.
inline Aiger stage(bool takes_always) {
  Aiger aiger;
  aiger.inputs = {"x_valid_i", "x_i[0]", "mutant[0]", "mutant[1]"};
  aiger.next.resize(2);
  const std::uint32_t valid = 2 * 5;
  const std::uint32_t data = 2 * 6;
  const std::uint32_t kept = takes_always ? 0 : aiger.add_gate(data, 3);
  const std::uint32_t taken = takes_always ? 4 : aiger.add_gate(4, 2);
  const std::uint32_t next = aiger.add_gate(kept ^ 1, taken ^ 1) ^ 1;
  const std::uint32_t flipped = aiger.add_gate(aiger.add_gate(next, 8) ^ 1, aiger.add_gate(next ^ 1, 9) ^ 1);
  aiger.next = {2, flipped};
  aiger.outputs = {{1, "x_ready_o"}, {valid, "y_valid_o"}, {data, "y_o[0]"}};
  return aiger;
}

}  // namespace feline::mutation
