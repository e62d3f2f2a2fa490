// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feline::mutation {

// Logic with state in the AIGER format (Biere, 2007): literals 0 and 1 are constants, 2v and 2v + 1 variable v and its
// opposite; variables are the inputs, then the latches, which begin with 0, then the AND gates.
struct Aiger {
  struct Gate {
    std::uint32_t left, right;  // of earlier variables
  };
  std::vector<std::string> inputs;  // their names, as "data_i[3]"; empty where the file tells none
  std::vector<std::uint32_t> next;  // of the latches
  std::vector<Gate> gates;
  struct Output {
    std::uint32_t literal;
    std::string name;
  };
  std::vector<Output> outputs;

  std::uint32_t first_latch() const { return static_cast<std::uint32_t>(inputs.size()) + 1; }
  std::uint32_t first_gate() const { return first_latch() + static_cast<std::uint32_t>(next.size()); }

  // The literal of "this gate", made with constants and equal operands left out.
  std::uint32_t add_gate(std::uint32_t left, std::uint32_t right);
};

// Reads the binary format. Throws std::runtime_error for what is not such a file.
Aiger read_aiger(std::string_view binary);
std::string to_binary(const Aiger& aiger);

// The same, `name`[first + i] having the value of bit i of `value`, 0 beyond it: the inputs stay, but nothing reads
// them.
Aiger with_input(const Aiger& aiger, std::string_view name, std::uint64_t value, std::uint32_t first = 0);

// Without state: an input for what each latch holds, an output for what it takes next.
Aiger cut_latches(const Aiger& aiger);

// Whether one behaves as the other to all who keep to the streams' rules: an output that is 1 when, with the same
// inputs so far, something that is looked at differs. Outputs X_valid_o and cut_X (cut_memories) are looked at always;
// X_ready_o while X_valid_i; others, as X_o or X_line_o, while the X_valid_o of the longest X there is; all only as
// long as an output legal_o, if there is one, was 1 in every cycle. A stream without a name is X, too: valid_o,
// ready_o, data_o. Of the same inputs, latches and outputs. Throws std::runtime_error for an output without a valid.
Aiger observed_difference(const Aiger& right, const Aiger& wrong);

// The port of a bit: "data_i" of "data_i[3]".
std::string port_of(const std::string& bit);

}  // namespace feline::mutation
