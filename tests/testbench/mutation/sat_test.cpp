// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/sat.h"

#include <gtest/gtest.h>

#include <array>

#include "testbench/random.h"

namespace feline::mutation {
namespace {

// The product of two numbers of `bits` bits each, in rows.
std::vector<std::uint32_t> product(Aiger& aiger, std::size_t bits) {
  const auto input = [](std::size_t i) { return static_cast<std::uint32_t>(2 * (i + 1)); };
  const auto exclusive = [&](std::uint32_t a, std::uint32_t b) {
    return aiger.add_gate(aiger.add_gate(a, b ^ 1) ^ 1, aiger.add_gate(a ^ 1, b) ^ 1) ^ 1;
  };
  std::vector<std::uint32_t> sum(2 * bits, 0);
  for (std::size_t row = 0; row < bits; ++row) {
    std::uint32_t carry = 0;
    for (std::size_t i = 0; i <= bits; ++i) {
      const std::uint32_t a = sum[row + i];
      const std::uint32_t b = i < bits ? aiger.add_gate(input(i), input(bits + row)) : 0;
      const std::uint32_t half = exclusive(a, b);
      sum[row + i] = exclusive(half, carry);
      carry = aiger.add_gate(aiger.add_gate(a, b) ^ 1, aiger.add_gate(half, carry) ^ 1) ^ 1;
      if (row + i + 1 == sum.size()) break;
    }
  }
  return sum;
}

// Whether a product of such numbers can be this one; if it can, of what is told.
bool can_be(std::size_t bits, std::uint64_t value) {
  Aiger aiger;
  aiger.inputs.assign(2 * bits, "");
  const std::vector<std::uint32_t> sum = product(aiger, bits);
  std::uint32_t is_it = 1;
  for (std::size_t i = 0; i < sum.size(); ++i) is_it = aiger.add_gate(is_it, sum[i] ^ ((value >> i & 1) != 0 ? 0 : 1));
  aiger.outputs.push_back({is_it, "is_it"});
  const Satisfied found = satisfy(aiger, 60);
  EXPECT_NE(found.answer, Satisfied::Answer::kUndecided);
  if (found.answer != Satisfied::Answer::kSometimes) return false;
  std::array<std::uint64_t, 2> factors{};
  for (std::size_t i = 0; i < 2 * bits; ++i) factors[i / bits] |= std::uint64_t{found.inputs[i]} << i % bits;
  EXPECT_EQ(factors[0] * factors[1], value);
  return true;
}

// Suites that need CaDiCaL are long ones.
TEST(sat_long, knows_what_can_be) {
  EXPECT_EQ(can_be(6, 59 * 61), true);
  EXPECT_EQ(can_be(6, 61 * 61 + 1), false);  // 2 * 1861, a prime
  EXPECT_EQ(can_be(6, 4093), false);         // a prime
  SplitMix64 random(1);
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t value = random.below(1U << 8);
    bool expected = false;
    for (std::uint64_t a = 0; a < 16; ++a) {
      for (std::uint64_t b = 0; b < 16; ++b) expected = expected || a * b == value;
    }
    EXPECT_EQ(can_be(4, value), expected) << value;
  }
}

TEST(sat_long, constants_are_decided) {
  Aiger aiger;
  aiger.inputs.assign(1, "");
  for (const std::uint32_t literal : {0U, 1U, 2U}) {
    aiger.outputs = {{literal, ""}};
    EXPECT_EQ(satisfy(aiger, 60).answer, literal != 0 ? Satisfied::Answer::kSometimes : Satisfied::Answer::kNever);
  }
}

}  // namespace
}  // namespace feline::mutation
