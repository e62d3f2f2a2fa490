// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/mutant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace feline::mutation {
namespace {

// y = a + b of four bits, of which the highest is not read; z = y[0] through a register; b[3] is the constant 1.
nlohmann::ordered_json netlist() {
  return nlohmann::ordered_json::parse(R"({"modules": {"top": {
    "ports": {"clk_i": {"direction": "input", "bits": [2]}, "a_i": {"direction": "input", "bits": [3, 4, 5, 6]},
              "b_i": {"direction": "input", "bits": [7, 8, 9]}, "z_o": {"direction": "output", "bits": [14]}},
    "cells": {
      "sum": {"type": "$add", "attributes": {"src": "rtl/top.sv:1|/x/rtl/top.sv:2.3-2.8"}, "parameters": {},
              "port_directions": {"A": "input", "B": "input", "Y": "output"},
              "connections": {"A": [3, 4, 5, 6], "B": [7, 8, 9, "1"], "Y": [10, 11, 12, 13]}},
      "register": {"type": "$dff", "attributes": {}, "parameters": {},
              "port_directions": {"CLK": "input", "D": "input", "Q": "output"},
              "connections": {"CLK": [2], "D": [10], "Q": [14]}}},
    "netnames": {"y": {"hide_name": 0, "bits": [10, 11, 12, 13], "attributes": {}}}}}})");
}

const Site& site_at(const InstrumentedStage& stage, const std::string& cell, const std::string& port) {
  for (const Site& site : stage.sites) {
    if (site.cell == cell && site.port == port) return site;
  }
  throw std::runtime_error("no site at " + cell + " " + port);
}

TEST(mutation_mutant, every_port_is_a_site_but_clocks) {
  const InstrumentedStage stage = instrument(netlist(), "top", nullptr, false);
  ASSERT_EQ(stage.sites.size(), 5U);
  EXPECT_EQ(site_at(stage, "sum", "A").bits.size(), 4U);
  EXPECT_TRUE(site_at(stage, "sum", "B").bits[3].constant);
  // Of the sum only the lowest bit is read.
  ASSERT_EQ(site_at(stage, "sum", "Y").bits.size(), 1U);
  EXPECT_EQ(site_at(stage, "sum", "Y").bits[0].place, 0U);
  const auto& cells = stage.netlist["modules"]["top"]["cells"];
  const std::string name = "mutation_" + std::to_string(site_at(stage, "sum", "Y").number);
  EXPECT_EQ(cells[name]["connections"]["data_o"], nlohmann::ordered_json::parse("[10, 11, 12, 13]"));
  EXPECT_EQ(cells["sum"]["connections"]["Y"], cells[name]["connections"]["data_i"]);
  EXPECT_TRUE(cells.contains("mutation_source"));
}

TEST(mutation_mutant, other_sites_stay_as_they_are) {
  const std::vector<std::uint32_t> only{2};
  const InstrumentedStage stage = instrument(netlist(), "top", &only, true);
  EXPECT_EQ(stage.sites.size(), 5U);
  const auto& module = stage.netlist["modules"]["top"];
  EXPECT_TRUE(module["cells"].contains("mutation_2"));
  EXPECT_FALSE(module["cells"].contains("mutation_1"));
  EXPECT_FALSE(module["cells"].contains("mutation_source"));
  EXPECT_EQ(module["ports"]["mutant"]["bits"].size(), 64U);
  EXPECT_THROW(instrument(netlist(), "other", nullptr, false), std::runtime_error);
}

TEST(mutation_mutant, ports_are_sites_when_they_are_wanted) {
  EXPECT_EQ(instrument(netlist(), "top", nullptr, false).ports.size(), 3U);
  const std::vector<std::uint32_t> only{6, 8};
  const InstrumentedStage stage = instrument(netlist(), "top", &only, true);
  ASSERT_EQ(stage.ports.size(), 3U);
  EXPECT_EQ(stage.ports[0].port, "a_i");
  EXPECT_EQ(stage.ports[0].number, 6U);
  const auto& module = stage.netlist["modules"]["top"];
  // What comes in passes the site; what goes out does, too.
  EXPECT_EQ(module["cells"]["mutation_6"]["connections"]["data_i"], module["ports"]["a_i"]["bits"]);
  EXPECT_EQ(module["cells"]["mutation_6"]["connections"]["data_o"], nlohmann::ordered_json::parse("[3, 4, 5, 6]"));
  EXPECT_FALSE(module["cells"].contains("mutation_7"));
  EXPECT_EQ(module["cells"]["mutation_8"]["connections"]["data_i"], nlohmann::ordered_json::parse("[14]"));
  EXPECT_EQ(module["cells"]["mutation_8"]["connections"]["data_o"], module["ports"]["z_o"]["bits"]);
}

TEST(mutation_mutant, mutants_differ_and_follow_from_the_seed) {
  const auto sites = instrument(netlist(), "top", nullptr, false).sites;
  const auto all = draw_mutants(sites, 100000, 1);
  // A: 4 bits x (3 + 2 x 3); B: 3 x 9 + 1; Y: 9; D: 3; Q: 3.
  EXPECT_EQ(all.size(), 36U + 28U + 9U + 3U + 3U);
  std::set<std::uint64_t> codes;
  for (const Mutant& mutant : all) codes.insert(code(mutant));
  EXPECT_EQ(codes.size(), all.size());
  EXPECT_FALSE(codes.contains(0));
  EXPECT_EQ(draw_mutants(sites, 20, 7), draw_mutants(sites, 20, 7));
  EXPECT_NE(draw_mutants(sites, 20, 7), draw_mutants(sites, 20, 8));
  EXPECT_EQ(draw_mutants(sites, 20, 7).size(), 20U);
}

TEST(mutation_mutant, every_bit_of_every_rom) {
  const auto mutants = rom_mutants({{"log2", 256, 8}, {"weight", 3, 2}});
  EXPECT_EQ(mutants.size(), 256U * 8 + 6);
  EXPECT_EQ(code(mutants.back()), 2U | 5U << 16 | 1U << 20 | std::uint64_t{2} << 32);
}

TEST(mutant, a_site_has_as_many_as_can_be_drawn) {
  Site site;
  site.number = 1;
  site.width = 3;
  site.bits = {{0, false}, {2, true}};
  std::vector<Mutant> all = site_mutants(site);
  std::vector<Mutant> drawn = draw_mutants({site}, 1000, 1);
  std::ranges::sort(all, {}, code);
  EXPECT_EQ(all.size(), 8U);
  EXPECT_EQ(all, drawn);
}

TEST(mutation_mutant, sites_are_numbered_once) {
  EXPECT_EQ(site_numbers({{7, Kind::kZero, 1, 0}, {3, Kind::kOne, 0, 0}, {7, Kind::kInvert, 0, 0}}),
            (std::vector<std::uint32_t>{3, 7}));
  EXPECT_TRUE(site_numbers({}).empty());
}

}  // namespace
}  // namespace feline::mutation
