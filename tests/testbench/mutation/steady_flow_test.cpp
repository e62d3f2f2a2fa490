// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/steady_flow.h"

#include <gtest/gtest.h>

#include "tests/testbench/mutation/small_stage.h"

namespace feline::mutation {
namespace {

constexpr std::uint64_t kFlipped = 2;  // the mutant of stage()

// Whether the only output is 1 for these data.
bool is_one(const Aiger& circuit, bool data) { return Simulator(circuit).cycle({false, data, false, false})[0]; }

TEST(steady_flow, data_that_move_a_beat_are_told) {
  Aiger aiger = stage(false);
  EXPECT_TRUE(moves_by_itself(aiger));
  // The next is valid when the data are 1, a cycle later.
  aiger.next[0] = aiger.add_gate(2, 4);
  EXPECT_FALSE(moves_by_itself(aiger));
  aiger.next[0] = aiger.add_gate(2, aiger.outputs[1].literal ^ 1);
  EXPECT_TRUE(moves_by_itself(aiger));
  aiger.outputs[0].literal = aiger.outputs[2].literal;
  EXPECT_FALSE(moves_by_itself(aiger));
}

TEST(steady_flow, a_pipeline_that_is_longer_is_told) {
  Aiger plain = with_input(stage(false), "mutant", 0);
  Aiger circuit{plain.inputs, {}, {}, {}};
  HashedGates gates(circuit);
  SteadyRun run(plain);
  run.step(gates);
  EXPECT_FALSE(run.comes_out());
  run.step(gates);
  EXPECT_TRUE(run.comes_out());
  plain.outputs.push_back({0, "legal_o"});
  SteadyRun never(plain);
  never.step(gates);
  never.step(gates);
  EXPECT_FALSE(never.comes_out());
}

TEST(steady_flow, registers_are_wires) {
  const Aiger plain = with_input(stage(false), "mutant", 0);
  Aiger circuit{plain.inputs, {}, {}, {}};
  HashedGates gates(circuit);
  SteadyRun run(plain);
  for (int cycle = 0; cycle < 3; ++cycle) run.step(gates);
  EXPECT_EQ(run.output(0), 1U);
  EXPECT_EQ(run.output(1), 1U);
  EXPECT_EQ(run.output(2), 4U) << "the data";
}

TEST(steady_flow, a_difference_is_seen_in_registers_first) {
  const Aiger plain = with_input(stage(false), "mutant", 0);
  const Aiger flipped = with_input(stage(false), "mutant", kFlipped);
  SteadyPair pair(plain, flipped);
  pair.step();
  EXPECT_TRUE(is_one(pair.registers_differ(), true));
  EXPECT_FALSE(is_one(pair.outputs_differ(), true)) << "it has not come out yet";
  pair.step();
  EXPECT_TRUE(is_one(pair.outputs_differ(), false));
  EXPECT_TRUE(is_one(pair.outputs_differ(), true));
}

TEST(steady_flow, what_registers_hold_is_what_comes_out) {
  const Aiger plain = with_input(stage(false), "mutant", 0);
  const Aiger flipped = with_input(stage(false), "mutant", kFlipped);
  SteadyPair pair(plain, flipped);
  pair.step();
  pair.make_same();
  EXPECT_EQ(pair.registers_differ().outputs[0].literal, 0U);
  pair.step();
  EXPECT_EQ(pair.outputs_differ().outputs[0].literal, 0U);
  // Taken always instead of when they are valid is the same when all are.
  const Aiger always = with_input(stage(true), "mutant", 0);
  SteadyPair same(plain, always);
  for (int cycle = 0; cycle < 3; ++cycle) same.step();
  EXPECT_EQ(same.outputs_differ().outputs[0].literal, 0U);
}

TEST(steady_flow, nothing_illegal_differs) {
  Aiger plain = with_input(stage(false), "mutant", 0);
  Aiger flipped = with_input(stage(false), "mutant", kFlipped);
  for (Aiger* const aiger : {&plain, &flipped}) aiger->outputs.push_back({4, "legal_o"});  // only a one is
  SteadyPair pair(plain, flipped);
  pair.step();
  EXPECT_TRUE(is_one(pair.registers_differ(), true));
  EXPECT_FALSE(is_one(pair.registers_differ(), false));
  EXPECT_TRUE(is_one(pair.legal(), true));
  EXPECT_FALSE(is_one(pair.legal(), false));
}

}  // namespace
}  // namespace feline::mutation
