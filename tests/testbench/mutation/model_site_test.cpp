// SPDX-License-Identifier: Apache-2.0
#include "testbench/mutation/model_site.h"

#include <gtest/gtest.h>

#include <string>

namespace feline::mutation {
namespace {

class mutation_model_site : public testing::Test {  // NOLINT(readability-identifier-naming): the suite's name
 protected:
  ~mutation_model_site() override {
    current_model_mutant = kNoModelMutant;
    reached_alternatives = nullptr;
  }
  static void choose(std::uint32_t site, std::uint32_t alternative) {
    current_model_mutant = site * kAlternatives + alternative;
  }
};

int sum(int a, int b, int c) { return a * Times<1>{} * b + Plus<2>{} + c; }

TEST_F(mutation_model_site, operators_keep_their_precedence) {
  EXPECT_EQ(sum(3, 5, 7), 22);
  choose(1, 0);
  EXPECT_EQ(sum(3, 5, 7), 15);
  choose(2, 0);
  EXPECT_EQ(sum(3, 5, 7), 8);
  choose(2, 1);
  EXPECT_EQ(sum(3, 5, 7), 15);
}

TEST_F(mutation_model_site, what_is_not_asked_for_stays_so) {
  int asked = 0;
  const auto ask = [&] {
    ++asked;
    return true;
  };
  bool never = false;
  EXPECT_FALSE(never && AndAlso<1>{} && ask());
  EXPECT_EQ(asked, 0);
  choose(1, 0);
  EXPECT_TRUE(never && AndAlso<1>{} && ask());
  EXPECT_EQ(asked, 1);
  choose(1, 1);
  EXPECT_TRUE(never && AndAlso<1>{} && ask());
}

TEST_F(mutation_model_site, conditions_and_values) {
  const auto chosen = [](bool a) { return a || Condition<1>{} ? 10 : 20; };
  EXPECT_EQ(chosen(true), 10);
  choose(1, 0);
  EXPECT_EQ(chosen(true), 20);
  choose(1, 1);
  EXPECT_EQ(chosen(false), 10);
  choose(1, 2);
  EXPECT_EQ(chosen(true), 20);
  choose(3, 0);
  EXPECT_EQ((Value<3>{} ^= 5), 6);
  EXPECT_EQ((Value<3>{} ^= true), false);
  choose(3, 1);
  EXPECT_EQ((Value<3>{} ^= 5 + 5), 0);
  choose(4, 1);
  EXPECT_EQ(literal<4>(5), 4);
  choose(5, 0);
  EXPECT_EQ(1 - Negative<5>{}->*2, -1);
}

// A constant is the same in every mutant, and a place that is only in constants is not reached.
TEST_F(mutation_model_site, constants_stay) {
  std::array<std::uint8_t, 16> reached{};
  reached_alternatives = reached.data();
  choose(1, 0);
  constexpr int kSum = 3 + Plus<1>{} + 4;
  EXPECT_EQ(kSum, 7);
  EXPECT_EQ(reached[1], 0);
  choose(2, 1);
  EXPECT_EQ(sum(3, 5, 7), 15);
  EXPECT_EQ(reached[1], 3);
  EXPECT_EQ(reached[2], 3);
  // Of what has no other value it is known that it was done.
  const std::string text = Value<3>{} ^= std::string("a");
  EXPECT_EQ(text, "a");
  EXPECT_EQ(reached[3], 1U << kHasNone);
}

}  // namespace
}  // namespace feline::mutation
