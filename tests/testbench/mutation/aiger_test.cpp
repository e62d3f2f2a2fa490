// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/aiger.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "testbench/random.h"
#include "tests/testbench/mutation/small_stage.h"

namespace feline::mutation {
namespace {

bool differs(const Aiger& miter) {
  Simulator simulator(miter);
  SplitMix64 random(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<bool> inputs;
    for (std::size_t k = 0; k < miter.inputs.size(); ++k) inputs.push_back(random.below(2) != 0);
    if (simulator.cycle(inputs)[0]) return true;
  }
  return false;
}

TEST(mutation_aiger, reads_what_it_writes) {
  const Aiger aiger = stage(false);
  const Aiger again = read_aiger(to_binary(aiger) + "i1 x_i[0]\no2 y_o[0]\nc\nwhatever");
  EXPECT_EQ(to_binary(again), to_binary(aiger));
  EXPECT_EQ(again.inputs[1], "x_i[0]");
  EXPECT_EQ(again.outputs[2].name, "y_o[0]");
}

TEST(mutation_aiger, refuses_what_is_no_logic) {
  const std::string good = to_binary(stage(false));
  EXPECT_THROW(read_aiger(""), std::runtime_error);
  EXPECT_THROW(read_aiger("aag 0 0 0 0 0\n"), std::runtime_error);
  EXPECT_THROW(read_aiger("aig 3 1 0 0 1\n\x02\x01"), std::runtime_error);  // a head that does not add up
  EXPECT_THROW(read_aiger("aig 1 1 0 1 0\n9\n"), std::runtime_error);       // an output of nothing
  EXPECT_THROW(read_aiger("aig 2 1 0 0 1\n\x09\x01"), std::runtime_error);  // a gate of a later one
  for (std::size_t size = 0; size + 1 < good.size(); ++size) {
    EXPECT_THROW(read_aiger(good.substr(0, size)), std::runtime_error) << size;
  }
}

TEST(mutation_aiger, an_input_becomes_a_constant) {
  const Aiger aiger = stage(false);
  for (const std::uint64_t value : {0U, 2U}) {
    const Aiger fixed = with_input(aiger, "mutant", value);
    ASSERT_EQ(fixed.inputs.size(), aiger.inputs.size());
    Simulator all(aiger);
    Simulator one(fixed);
    SplitMix64 random(3);
    for (int i = 0; i < 200; ++i) {
      std::vector<bool> inputs{random.below(2) != 0, random.below(2) != 0, false, value == 2};
      const auto expected = all.cycle(inputs);
      inputs[3] = random.below(2) != 0;  // nothing reads it
      EXPECT_EQ(one.cycle(inputs), expected);
    }
  }
}

TEST(mutation_aiger, bits_beyond_the_value_are_zeros) {
  Aiger aiger;
  aiger.inputs = {"x[0]", "x[64]", "x[65", "x_valid_i"};
  for (std::uint32_t i = 0; i < 4; ++i) aiger.outputs.push_back({2 * (i + 1), "y"});
  const auto outputs = with_input(aiger, "x", ~std::uint64_t{0}).outputs;
  EXPECT_EQ(outputs[0].literal, 1U);
  EXPECT_EQ(outputs[1].literal, 0U);
  EXPECT_EQ(outputs[2].literal, 6U);
  EXPECT_EQ(outputs[3].literal, 8U);
  const auto above = with_input(aiger, "x", 1, 64).outputs;
  EXPECT_EQ(above[0].literal, 2U) << "below the first";
  EXPECT_EQ(above[1].literal, 1U);
}

TEST(mutation_aiger, data_that_are_not_valid_are_not_looked_at) {
  const Aiger right = with_input(stage(false), "mutant", 0);
  EXPECT_FALSE(differs(observed_difference(right, right)));
  EXPECT_FALSE(differs(observed_difference(right, with_input(stage(true), "mutant", 0))));
  EXPECT_TRUE(differs(observed_difference(right, with_input(stage(false), "mutant", 2))));
}

TEST(mutation_aiger, nothing_is_looked_at_after_an_illegal_cycle) {
  Aiger right = with_input(stage(false), "mutant", 0);
  Aiger wrong = with_input(stage(false), "mutant", 2);
  for (Aiger* const aiger : {&right, &wrong}) aiger->outputs.push_back({0, "legal_o"});
  EXPECT_FALSE(differs(observed_difference(right, wrong)));
  for (Aiger* const aiger : {&right, &wrong}) aiger->outputs.back().literal = 1;
  EXPECT_TRUE(differs(observed_difference(right, wrong)));
}

TEST(mutation_aiger, nothing_is_illegal_in_a_reset) {
  Aiger right = with_input(stage(false), "mutant", 0);
  Aiger wrong = with_input(stage(false), "mutant", 2);
  for (Aiger* const aiger : {&right, &wrong}) {
    aiger->outputs.push_back({0, "legal_o"});
    aiger->inputs.back() = "rst_i";
  }
  const Aiger miter = observed_difference(right, wrong);
  for (const bool reset : {false, true}) {
    Simulator simulator(miter);
    bool is_seen = false;
    for (int cycle = 0; cycle < 3; ++cycle) is_seen = simulator.cycle({true, true, false, reset})[0] || is_seen;
    EXPECT_EQ(is_seen, reset);
  }
}

TEST(mutation_aiger, what_a_memory_is_given_is_looked_at) {
  Aiger right = with_input(stage(false), "mutant", 0);
  Aiger wrong = right;
  right.outputs.push_back({2, "cut_0_WR_ADDR_o[1]"});
  wrong.outputs.push_back({4, "cut_0_WR_ADDR_o[1]"});
  EXPECT_FALSE(differs(observed_difference(right, right)));
  EXPECT_TRUE(differs(observed_difference(right, wrong)));
}

TEST(mutation_aiger, an_output_needs_a_valid) {
  Aiger aiger = stage(false);
  aiger.outputs.push_back({2, "z_o[1]"});
  EXPECT_THROW(observed_difference(aiger, aiger), std::runtime_error);
}

}  // namespace
}  // namespace feline::mutation
