// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/memory_model.h"

#include <gtest/gtest.h>

namespace feline {
namespace {

TextureMemory two_lines() {
  TextureMemory memory;
  memory.bytes.assign(2 * kLineBytes, 0);
  memory.bytes[kLineBytes] = 1;
  return memory;
}

Conditions latency(int cycles) {
  Conditions conditions;
  conditions.memory_latency = cycles;
  return conditions;
}

TEST(memory_model, answers_as_many_cycles_after_its_request_as_it_says) {
  const TextureMemory lines = two_lines();
  for (const int cycles : {1, 2, 1000}) {
    MemoryModel memory(lines, latency(cycles), 1);
    memory.begin_cycle(0);
    EXPECT_FALSE(memory.responds_in_same_cycle());
    ASSERT_TRUE(memory.take_request(1, 0));
    EXPECT_FALSE(memory.response_valid());
    std::uint64_t cycle = 1;
    for (; memory.begin_cycle(cycle), !memory.response_valid(); ++cycle) ASSERT_LT(cycle, 2000U);
    EXPECT_EQ(cycle, static_cast<std::uint64_t>(cycles));
    EXPECT_EQ(memory.response()[0], 1);
  }
}

TEST(memory_model, answers_in_the_cycle_of_its_request_and_until_that_is_taken) {
  const TextureMemory lines = two_lines();
  MemoryModel memory(lines, latency(0), 1);
  memory.begin_cycle(0);
  EXPECT_TRUE(memory.responds_in_same_cycle());
  EXPECT_FALSE(memory.response_valid()) << "nothing is asked yet";
  ASSERT_TRUE(memory.take_request(1, 0));
  EXPECT_TRUE(memory.response_valid());
  for (std::uint64_t cycle = 1; cycle < 4; ++cycle) {
    memory.begin_cycle(cycle);
    EXPECT_FALSE(memory.responds_in_same_cycle()) << "one is in front";
    ASSERT_TRUE(memory.response_valid());
    EXPECT_EQ(memory.response()[0], 1);
  }
  memory.take_response();
  memory.begin_cycle(4);
  EXPECT_FALSE(memory.response_valid());
  EXPECT_TRUE(memory.responds_in_same_cycle());
  EXPECT_EQ(memory.requests(), 1U);
}

TEST(memory_model, a_stall_makes_an_answer_later) {
  const TextureMemory lines = two_lines();
  Conditions conditions = latency(0);
  conditions.at(Port::kMemoryResponse) = {0.5, 1};
  MemoryModel memory(lines, conditions, 1);
  int late = 0;
  for (std::uint64_t cycle = 0; cycle < 1000; cycle += 10) {
    memory.begin_cycle(cycle);
    const bool at_once = memory.responds_in_same_cycle();
    ASSERT_TRUE(memory.take_request(0, cycle));
    EXPECT_EQ(memory.response_valid(), at_once);
    late += at_once ? 0 : 1;
    for (std::uint64_t wait = cycle; !memory.response_valid();) {
      ASSERT_LT(++wait, cycle + 10);
      memory.begin_cycle(wait);
    }
    memory.take_response();
  }
  EXPECT_GT(late, 20);
  EXPECT_LT(late, 80);
}

TEST(memory_model, there_are_no_lines_beyond_the_last) {
  const TextureMemory lines = two_lines();
  MemoryModel memory(lines, latency(1), 1);
  memory.begin_cycle(0);
  EXPECT_FALSE(memory.take_request(2, 0));
}

}  // namespace
}  // namespace feline
