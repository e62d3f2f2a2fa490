// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/elaboration.h"

#include <gtest/gtest.h>

namespace feline::mutation {
namespace {

using Json = nlohmann::ordered_json;

TEST(mutation_elaboration, a_memory_is_cut_where_it_is_read_and_written) {
  Json module = Json::parse(R"({
    "ports": {"clk_i": {"direction": "input", "bits": [2]}},
    "cells": {
      "sum": {"type": "$add", "connections": {"A": [9], "B": [9], "Y": [10]}},
      "memory": {"type": "$mem_v2", "connections": {"RD_CLK": ["x"], "RD_EN": ["1"], "RD_ADDR": [3, 4],
                 "RD_DATA": [5, 6], "WR_CLK": [2], "WR_ADDR": [7, "0"], "WR_DATA": [8, 9], "WR_EN": [10, 10]}}}})");
  cut_memories(module);
  EXPECT_FALSE(module["cells"].contains("memory"));
  EXPECT_TRUE(module["cells"].contains("sum"));
  EXPECT_EQ(module["ports"].size(), 6U);
  EXPECT_EQ(module["ports"]["cut_0_RD_DATA_i"], Json::parse(R"({"direction": "input", "bits": [5, 6]})"));
  EXPECT_EQ(module["ports"]["cut_0_RD_ADDR_o"], Json::parse(R"({"direction": "output", "bits": [3, 4]})"));
  EXPECT_EQ(module["ports"]["cut_0_WR_ADDR_o"], Json::parse(R"({"direction": "output", "bits": [7, "0"]})"));
  EXPECT_EQ(module["ports"]["cut_0_WR_DATA_o"]["bits"], Json::parse("[8, 9]"));
  EXPECT_EQ(module["ports"]["cut_0_WR_EN_o"]["bits"], Json::parse("[10, 10]"));
}

}  // namespace
}  // namespace feline::mutation
