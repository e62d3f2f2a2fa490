// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/netlist.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "testbench/random.h"
#include "tests/support/random.h"

namespace feline::prove {
namespace {

using Json = nlohmann::json;

constexpr std::array<const char*, 10> kTypes{"$_AND_", "$_ANDNOT_", "$_OR_",   "$_ORNOT_", "$_NAND_",
                                             "$_NOR_", "$_XOR_",    "$_XNOR_", "$_NOT_",   "$_MUX_"};

// What the cell does, said once more.
bool gate(std::size_t type, bool a, bool b, bool s) {
  const std::array<bool, 10> all{a && b, a && !b, a || b, a || !b, !(a && b), !(a || b), a != b, a == b, !a, s ? b : a};
  return all[type];
}

// A module of random gates: inputs are nets 2 .. 2 + inputs - 1, and each gate makes the next net.
struct RandomModule {
  Json json;
  std::vector<std::array<std::uint32_t, 4>> gates;  // type, A, B, S
  std::uint32_t inputs;
  std::vector<std::uint32_t> outputs;

  RandomModule(std::uint64_t seed, std::uint32_t input_count, std::uint32_t gate_count, std::uint32_t output_count)
      : inputs(input_count) {
    SplitMix64 draw(seed);
    Json cells = Json::object();
    const auto bit = [](std::uint32_t net) { return net < 2 ? Json(net == 1 ? "1" : "0") : Json(net); };
    for (std::uint32_t i = 0; i < gate_count; ++i) {
      const std::uint32_t type = draw.below(10);
      const std::uint32_t nets = 2 + inputs + i;
      gates.push_back({type, draw.below(nets), draw.below(nets), draw.below(nets)});
      Json wires{{"A", {bit(gates.back()[1])}}, {"Y", {nets}}};
      if (type != 8) wires["B"] = {bit(gates.back()[2])};
      if (type == 9) wires["S"] = {bit(gates.back()[3])};
      cells[fmt::format("g{}", (i * 7919) % gate_count)] = {{"type", kTypes[type]}, {"connections", wires}};
    }
    Json in = Json::array();
    Json out = Json::array();
    for (std::uint32_t i = 0; i < inputs; ++i) in.push_back(2 + i);
    for (std::uint32_t i = 0; i < output_count; ++i) {
      outputs.push_back(draw.below(2 + inputs + gate_count));
      out.push_back(bit(outputs.back()));
    }
    json["modules"]["top"] = {{"ports", {{"inputs_i", {{"bits", in}}}, {"outputs_o", {{"bits", out}}}}},
                              {"cells", cells}};
  }

  std::vector<bool> evaluate(const std::vector<bool>& bits) const {
    std::vector<bool> nets{false, true};
    nets.insert(nets.end(), bits.begin(), bits.end());
    for (const auto& [type, a, b, s] : gates) nets.push_back(gate(type, nets[a], nets[b], nets[s]));
    std::vector<bool> result;
    for (const std::uint32_t net : outputs) result.push_back(nets[net]);
    return result;
  }
};

std::vector<std::uint64_t> random_lanes(std::uint64_t seed, std::size_t lanes, std::size_t words) {
  SplitMix64 draw(seed);
  std::vector<std::uint64_t> all(lanes * words);
  for (std::uint64_t& word : all) word = draw.next();
  return all;
}

void expect_same(const RandomModule& module, const NetlistProgram& program, const std::vector<std::uint64_t>& inputs,
                 std::size_t lanes) {
  const std::size_t in_words = (module.inputs + 63) / 64;
  const std::size_t out_words = (module.outputs.size() + 63) / 64;
  std::vector<std::uint64_t> outputs(lanes * out_words, ~std::uint64_t{0});
  std::vector<std::uint64_t> scratch;
  program.evaluate(inputs.data(), in_words, outputs.data(), out_words, lanes, scratch);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    std::vector<bool> bits;
    for (std::uint32_t i = 0; i < module.inputs; ++i) {
      bits.push_back((inputs[lane * in_words + i / 64] >> (i % 64) & 1) != 0);
    }
    const std::vector<bool> expected = module.evaluate(bits);
    for (std::size_t i = 0; i < out_words * 64; ++i) {
      const bool got = (outputs[lane * out_words + i / 64] >> (i % 64) & 1) != 0;
      ASSERT_EQ(got, i < expected.size() && expected[i]) << "lane " << lane << ", output " << i;
    }
  }
}

TEST(netlist, does_what_its_gates_do) {
  const SeedTrace trace(__FILE__, __LINE__);
  for (std::uint64_t seed = feline::seed(); seed < feline::seed() + 20; ++seed) {
    const RandomModule module(seed, 5 + static_cast<std::uint32_t>(seed % 90), 300,
                              1 + static_cast<std::uint32_t>(seed % 80));
    const Netlist netlist(module.json.dump(), "top");
    EXPECT_LE(netlist.gates.size(), 300U);
    for (const std::size_t lanes : {std::size_t{1}, std::size_t{63}, std::size_t{700}, NetlistProgram::kLanes}) {
      expect_same(module, NetlistProgram(netlist), random_lanes(seed, lanes, (module.inputs + 63) / 64), lanes);
    }
  }
}

TEST(netlist, constants_only_leave_gates_out) {
  std::size_t left = 0;
  std::size_t all = 0;
  const SeedTrace trace(__FILE__, __LINE__);
  for (std::uint64_t seed = feline::seed(); seed < feline::seed() + 20; ++seed) {
    const RandomModule module(seed, 70, 300, 66);
    const Netlist netlist(module.json.dump(), "top");
    const std::vector<std::uint64_t> mask{SplitMix64(seed).next(), 0x3f};
    const std::vector<std::uint64_t> bits{SplitMix64(seed + 1).next() & mask[0], 0x15};
    const Netlist fixed = netlist.with_constants(mask, bits);
    left += fixed.gates.size();
    all += netlist.gates.size();
    std::vector<std::uint64_t> inputs = random_lanes(seed, 500, 2);
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs[i] = (inputs[i] & ~mask[i % 2]) | bits[i % 2];
    expect_same(module, NetlistProgram(fixed), inputs, 500);
  }
  EXPECT_LT(left, all * 3 / 4);
}

std::string refusal(const Json& json) {
  try {
    const Netlist netlist(json.dump(), "top");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(netlist, refuses_other_cells_and_loops) {
  Json json = RandomModule(1, 4, 3, 1).json;
  Json& cells = json["modules"]["top"]["cells"];
  cells["flop"] = {{"type", "$_DFF_P_"}, {"connections", {{"D", {2}}, {"Q", {90}}}}};
  EXPECT_NE(refusal(json).find("flop of type $_DFF_P_"), std::string::npos) << refusal(json);
  cells.clear();
  cells["a"] = {{"type", "$_AND_"}, {"connections", {{"A", {2}}, {"B", {91}}, {"Y", {90}}}}};
  cells["b"] = {{"type", "$_NOT_"}, {"connections", {{"A", {90}}, {"Y", {91}}}}};
  json["modules"]["top"]["ports"]["outputs_o"]["bits"] = {91};
  EXPECT_NE(refusal(json).find("loop"), std::string::npos) << refusal(json);
}

TEST(netlist, refuses_what_yosys_does_not_write) {
  const auto module = [](const std::string& cells, const std::string& out) {
    return R"({"modules": {"top": {"ports": {"inputs_i": {"bits": [2, 3]}, "outputs_o": {"bits": [)" + out +
           "]}}, \"cells\": {" + cells + "}}}}";
  };
  const auto gate = [](const std::string& name, const std::string& a, const std::string& y) {
    return "\"" + name + R"(": {"type": "$_NOT_", "connections": {"A": [)" + a + "], \"Y\": [" + y + "]}}";
  };
  const auto program = [](const std::string& text) { return NetlistProgram(Netlist(text, "top")); };
  EXPECT_NO_THROW(program(module(gate("a", "2", "4"), "4")));
  const std::vector<std::string> all_wrong{
      "{",
      "{}",
      module(gate("a", "4", "4"), "4"),                              // a loop
      module(gate("a", "2", "4") + "," + gate("b", "3", "4"), "4"),  // two drivers
      module(gate("a", "2", "3"), "3"),                              // of an input
      module(gate("a", "2", "\"1\""), "2"),                          // of a constant
      module(gate("a", "9", "4"), "4"),                              // none
      module("", "9"),                                               // of an output
      module(gate("a", "-2", "4"), "4"),                             // no numbers of nets
      module(gate("a", "1", "4"), "4"),
      module(gate("a", "2", "4294967296"), "2"),
      module(R"("a": {"type": "$_NOT_", "connections": {"Y": [4]}})", "4"),  // no A
      R"({"modules": {"top": {"ports": {"inputs_i": {"bits": ["1"]}, "outputs_o": {"bits": []}}, "cells": {}}}})"};
  for (const std::string& wrong : all_wrong) {
    EXPECT_THROW(program(wrong), std::runtime_error) << wrong;
  }
}

}  // namespace
}  // namespace feline::prove
