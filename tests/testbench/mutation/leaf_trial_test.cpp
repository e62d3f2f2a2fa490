// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/leaf_trial.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "testbench/random.h"
#include "tests/support/random.h"

namespace feline::mutation {
namespace {

constexpr std::uint32_t kInputs = 6;
constexpr std::uint32_t kMutantBits = 3;

// Gates at random over inputs_i and mutant, which are among each other.
Aiger random_logic(SplitMix64& random) {
  Aiger aiger;
  for (std::uint32_t i = 0; i < kInputs; ++i) {
    aiger.inputs.push_back(fmt::format("inputs_i[{}]", kInputs - 1 - i));
    if (i < kMutantBits) aiger.inputs.push_back(fmt::format("mutant[{}]", i));
  }
  while (aiger.gates.size() < 40) {
    const std::uint32_t end = 2 * (aiger.first_gate() + static_cast<std::uint32_t>(aiger.gates.size()));
    aiger.add_gate(random.below(end), random.below(end));
  }
  const std::uint32_t end = 2 * (aiger.first_gate() + 40);
  for (int i = 0; i < 3; ++i) aiger.outputs.push_back({random.below(end), "outputs_o"});
  return aiger;
}

std::vector<bool> outputs_of(const Aiger& aiger, std::uint64_t inputs, std::uint64_t mutant) {
  std::vector<bool> values{false};
  for (const std::string& name : aiger.inputs) {
    const bool of_leaf = name.starts_with("inputs_i[");
    const auto place = static_cast<unsigned>(name[name.size() - 2] - '0');
    values.push_back(((of_leaf ? inputs : mutant) >> place & 1) != 0);
  }
  const auto read = [&](std::uint32_t literal) { return values[literal / 2] != ((literal & 1) != 0); };
  for (const Aiger::Gate& gate : aiger.gates) values.push_back(read(gate.left) && read(gate.right));
  std::vector<bool> outputs;
  for (const Aiger::Output& output : aiger.outputs) outputs.push_back(read(output.literal));
  return outputs;
}

TEST(leaf_trial, the_netlist_of_differences_tells_which_mutants_differ) {
  const SeedTrace trace(__FILE__, __LINE__);
  SplitMix64 random(seed());
  std::size_t differ = 0;
  for (int round = 0; round < 50; ++round) {
    const Aiger logic = random_logic(random);
    const std::vector<std::uint64_t> codes{0, 1, 2, 3, 4, 5, 6, 7};
    const prove::NetlistProgram program(difference_netlist(logic, codes));
    std::vector<std::uint64_t> inputs;
    for (std::uint64_t i = 0; i < 1U << kInputs; ++i) inputs.push_back(i);
    std::vector<std::uint64_t> got(inputs.size());
    std::vector<std::uint64_t> scratch;
    program.evaluate(inputs.data(), 1, got.data(), 1, inputs.size(), scratch);
    for (const std::uint64_t input : inputs) {
      for (const std::uint64_t code : codes) {
        const bool expected = outputs_of(logic, input, code) != outputs_of(logic, input, 0);
        ASSERT_EQ((got[input] >> code & 1) != 0, expected) << input << " " << code;
        differ += expected ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(differ, 100U);
}

TEST(leaf_trial, logic_with_state_is_no_leaf) {
  Aiger aiger;
  aiger.next = {0};
  EXPECT_THROW(difference_netlist(aiger, {}), std::runtime_error);
}

// All bits of the input at once, inverted by mutant[0]; mutant[1] inverts it where the lowest bits are one, mutant[2]
// never.
Aiger all_ones(std::uint32_t bits) {
  Aiger aiger;
  for (std::uint32_t i = 0; i < bits; ++i) aiger.inputs.push_back(fmt::format("inputs_i[{}]", i));
  for (std::uint32_t i = 0; i < kMutantBits; ++i) aiger.inputs.push_back(fmt::format("mutant[{}]", i));
  std::uint32_t all = 1;
  std::uint32_t low = 1;
  for (std::uint32_t i = 0; i < bits; ++i) {
    all = aiger.add_gate(all, 2 * (i + 1));
    if (i < bits - 2) low = all;
  }
  const auto mutant = [&](std::uint32_t i) { return 2 * (bits + 1 + i); };
  const std::uint32_t inverts =
      aiger.add_gate(aiger.add_gate(mutant(0), all) ^ 1, aiger.add_gate(mutant(1), low) ^ 1) ^ 1;
  aiger.outputs = {{aiger.add_gate(aiger.add_gate(all, inverts) ^ 1, aiger.add_gate(all ^ 1, inverts ^ 1) ^ 1), "o"}};
  return aiger;
}

TEST(leaf_trial, the_one_input_that_differs_is_found) {
  constexpr int kBits = 22;
  static constexpr std::array kFields{Format{"x", false, kBits, 0, "1"}};
  prove::Leaf leaf;
  leaf.name = "walk.invented";
  leaf.inputs = leaf.outputs = kFields;
  leaf.input_words = leaf.output_words = 1;
  leaf.domain.count = std::uint64_t{1} << kBits;
  leaf.domain.fill = [](std::uint64_t first, std::size_t lanes, std::uint64_t* out) {
    for (std::size_t i = 0; i < lanes; ++i) out[i] = first + i;
  };
  const std::vector<std::uint64_t> codes{4, 2, 1};
  const std::uint64_t last = leaf.domain.count - 1;
  const auto found = differing_inputs(leaf, all_ones(kBits), codes, leaf.domain.count);
  EXPECT_EQ(found[0], std::nullopt);
  ASSERT_TRUE(found[1].has_value());
  EXPECT_EQ(*found[1] % (std::uint64_t{1} << (kBits - 2)), last >> 2);  // any of four
  EXPECT_EQ(found[2], last);
  EXPECT_EQ(differing_inputs(leaf, all_ones(kBits), codes, 1000)[2], std::nullopt);
  leaf.steady_fields = 1;
  EXPECT_EQ(differing_inputs(leaf, all_ones(kBits), codes, leaf.domain.count), found);
}

}  // namespace
}  // namespace feline::mutation
