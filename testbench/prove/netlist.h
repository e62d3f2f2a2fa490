// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace feline::prove {

// A combinational module as gates, from JSON that Yosys writes (`abc -g` with gates of at most two inputs, and MUX):
// what synthesis made of the RTL, independent of Verilator.
struct Netlist {
  enum class Kind : std::uint8_t { kAnd, kAndNot, kOr, kOrNot, kNand, kNor, kXor, kXnor, kNot, kMux };
  // Nets are numbers; 0 and 1 are the constants. A gate reads A, B and, of a MUX, S: S ? B : A.
  struct Gate {
    Kind kind = Kind::kAnd;
    std::array<std::uint32_t, 3> reads{};
    std::uint32_t writes = 0;
  };

  // Throws std::runtime_error for a module that holds anything else, a loop, or a net of two drivers. Ports are
  // inputs_i and outputs_o.
  Netlist(std::string_view json, std::string_view module);

  // Those of these gates, in any order, that outputs need. Throws std::runtime_error for a loop.
  Netlist(const std::vector<Gate>& all_gates, std::vector<std::uint32_t> input_nets,
          std::vector<std::uint32_t> output_nets);

  // What is left when bits of the inputs are constant: those of `mask` have the value in `bits` (lanes, as in
  // testbench/prove/lane.h).
  Netlist with_constants(std::span<const std::uint64_t> mask, std::span<const std::uint64_t> bits) const;

  std::vector<Gate> gates;                     // each after those whose nets it reads
  std::vector<std::uint32_t> inputs, outputs;  // the net of each bit

 private:
  Netlist() = default;
  void read(const nlohmann::json& top, std::string_view module);
};

// Gates in places: evaluates bit-sliced, one bit of a word being one lane.
class NetlistProgram {
 public:
  static constexpr std::size_t kLanes = 8192;

  explicit NetlistProgram(const Netlist& netlist);

  // Lanes of `input_words` and `output_words` 64-bit words; count <= kLanes. `scratch` grows as needed.
  void evaluate(const std::uint64_t* inputs, std::size_t input_words, std::uint64_t* outputs, std::size_t output_words,
                std::size_t count, std::vector<std::uint64_t>& scratch) const;

 private:
  static constexpr std::size_t kWords = kLanes / 64;  // of a slot
  // A gate reads and writes slots: values that are no longer needed make room for others.
  struct Step {
    Netlist::Kind kind;
    std::uint32_t a, b, select, out;
  };
  static void run(const Step* steps, std::size_t count, std::uint64_t* slots);

  std::vector<Step> steps_;
  std::vector<std::uint32_t> inputs_, outputs_;  // the slot of each bit
  std::size_t slots_ = 2;
};

}  // namespace feline::prove
