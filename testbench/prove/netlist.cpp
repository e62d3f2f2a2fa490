// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/netlist.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "testbench/json_input.h"

namespace feline::prove {
namespace {

using Gate = Netlist::Gate;
using Kind = Netlist::Kind;

constexpr std::array<std::string_view, 10> kCells{"$_AND_", "$_ANDNOT_", "$_OR_",   "$_ORNOT_", "$_NAND_",
                                                  "$_NOR_", "$_XOR_",    "$_XNOR_", "$_NOT_",   "$_MUX_"};
constexpr std::uint32_t kZero = 0;
constexpr std::uint32_t kOne = 1;

std::uint32_t net_of(const nlohmann::json& bit) {
  if (bit.is_number()) {
    const auto net = whole_from_json<std::uint32_t>(bit);
    if (net <= kOne) throw std::runtime_error("nets are numbered from 2 on");
    return net;
  }
  // An unknown is never to matter.
  return bit.get<std::string>() == "1" ? kOne : kZero;
}

// The gates that outputs need, each after those whose nets it reads.
std::vector<Gate> sorted(const std::vector<Gate>& gates, const std::vector<std::uint32_t>& outputs) {
  std::unordered_map<std::uint32_t, std::size_t> writer;
  for (std::size_t i = 0; i < gates.size(); ++i) writer[gates[i].writes] = i;
  std::vector<Gate> order;
  std::vector<std::uint8_t> state(gates.size(), 0);  // 1: waits for what it reads; 2: is in `order`
  std::vector<std::size_t> stack;
  for (const std::uint32_t output : outputs) {
    if (const auto it = writer.find(output); it != writer.end()) stack.push_back(it->second);
    while (!stack.empty()) {
      const std::size_t i = stack.back();
      const bool waited = state[i] == 1;
      if (state[i] == 0) state[i] = 1;
      bool ready = true;
      for (const std::uint32_t net : gates[i].reads) {
        const auto it = writer.find(net);
        if (it == writer.end() || state[it->second] == 2) continue;
        if (waited) throw std::runtime_error("a loop of gates");
        stack.push_back(it->second);
        ready = false;
      }
      if (!ready) continue;
      stack.pop_back();
      if (state[i] != 2) order.push_back(gates[i]);
      state[i] = 2;
    }
  }
  return order;
}

// The value of a gate whose inputs are constants.
bool value_of(Kind kind, bool a, bool b, bool select) {
  switch (kind) {
    case Kind::kAnd: return a && b;
    case Kind::kAndNot: return a && !b;
    case Kind::kOr: return a || b;
    case Kind::kOrNot: return a || !b;
    case Kind::kNand: return !(a && b);
    case Kind::kNor: return !(a || b);
    case Kind::kXor: return a != b;
    case Kind::kXnor: return a == b;
    case Kind::kNot: return !a;
    case Kind::kMux: return select ? b : a;
  }
  return false;
}

constexpr bool is_constant(std::uint32_t net) { return net <= kOne; }

}  // namespace

Netlist::Netlist(std::string_view json, std::string_view module) {
  try {
    const nlohmann::json all = nlohmann::json::parse(json);
    read(all.at("modules").at(std::string(module)), module);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: not what Yosys writes: {}", module, error.what()));
  }
  std::unordered_set<std::uint32_t> driven{kZero, kOne};
  const auto drive = [&](std::uint32_t net) {
    if (!driven.insert(net).second) throw std::runtime_error(fmt::format("{}: net {} has two drivers", module, net));
  };
  for (const std::uint32_t net : inputs) drive(net);
  for (const Gate& gate : gates) drive(gate.writes);
  // Yosys' order is by name: in that of nets it does not depend on it.
  std::ranges::sort(gates, {}, &Gate::writes);
  gates = sorted(gates, outputs);
}

Netlist::Netlist(const std::vector<Gate>& all_gates, std::vector<std::uint32_t> input_nets,
                 std::vector<std::uint32_t> output_nets)
    : gates(sorted(all_gates, output_nets)), inputs(std::move(input_nets)), outputs(std::move(output_nets)) {}

void Netlist::read(const nlohmann::json& top, std::string_view module) {
  for (const auto& [port, nets] : {std::pair{"inputs_i", &inputs}, {"outputs_o", &outputs}}) {
    for (const nlohmann::json& bit : top.at("ports").at(port).at("bits")) nets->push_back(net_of(bit));
  }
  for (const auto& [name, cell] : top.at("cells").items()) {
    const auto type = cell.at("type").get<std::string>();
    const auto* const known = std::ranges::find(kCells, type);
    if (known == kCells.end()) {
      throw std::runtime_error(fmt::format("{}: cell {} of type {}, expected gates alone", module, name, type));
    }
    const nlohmann::json& wires = cell.at("connections");
    const auto pin = [&](const char* name) { return net_of(wires.at(name).at(0)); };
    const auto kind = static_cast<Kind>(known - kCells.begin());
    gates.push_back(
        {kind, {pin("A"), kind == Kind::kNot ? kZero : pin("B"), kind == Kind::kMux ? pin("S") : kZero}, pin("Y")});
  }
}

Netlist Netlist::with_constants(std::span<const std::uint64_t> mask, std::span<const std::uint64_t> bits) const {
  std::unordered_map<std::uint32_t, std::uint32_t> instead;  // of a net: a constant, or a net that is the same
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if ((mask[i / 64] >> (i % 64) & 1) != 0) instead[inputs[i]] = bits[i / 64] >> (i % 64) & 1 ? kOne : kZero;
  }
  const auto now = [&](std::uint32_t net) {
    const auto it = instead.find(net);
    return it == instead.end() ? net : it->second;
  };
  Netlist left;
  left.inputs = inputs;
  for (Gate gate : gates) {
    for (std::uint32_t& net : gate.reads) net = now(net);
    const std::uint32_t a = gate.reads[0];
    const std::uint32_t b = gate.reads[1];
    const std::uint32_t select = gate.reads[2];
    const bool is_mux = gate.kind == Kind::kMux;
    if (gate.kind == Kind::kNot || (is_mux && is_constant(select))) {
      if (is_mux) {
        instead[gate.writes] = select == kOne ? b : a;
      } else if (is_constant(a)) {
        instead[gate.writes] = a == kOne ? kZero : kOne;
      } else {
        left.gates.push_back(gate);
      }
      continue;
    }
    if (!is_mux && (is_constant(a) || is_constant(b))) {
      // As a function of the other input.
      const bool a_is_constant = is_constant(a);
      const auto with = [&](bool other) {
        return a_is_constant ? value_of(gate.kind, a == kOne, is_constant(b) ? b == kOne : other, false)
                             : value_of(gate.kind, other, b == kOne, false);
      };
      const std::uint32_t other = a_is_constant ? b : a;
      if (with(false) == with(true)) {
        instead[gate.writes] = with(false) ? kOne : kZero;
      } else if (with(true)) {
        instead[gate.writes] = other;
      } else {
        left.gates.push_back({Kind::kNot, {other, kZero, kZero}, gate.writes});
      }
      continue;
    }
    left.gates.push_back(gate);
  }
  for (const std::uint32_t net : outputs) left.outputs.push_back(now(net));
  left.gates = sorted(left.gates, left.outputs);
  return left;
}

}  // namespace feline::prove
