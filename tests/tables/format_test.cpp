// SPDX-License-Identifier: Apache-2.0
#include "tables/format.h"

#include <gtest/gtest.h>

#include <set>

#include "tables/formats.h"

namespace feline {
namespace {

using F = Formats<kDefaultConfig>;

// Formats of equal width do not mix: neither assignment, nor comparison, nor construction.
template <typename A, typename B>
concept Mixes = requires(A a, B b) {
  a = b;
}
|| requires(A a, B b) { a == b; }
|| requires(B b) { A(b); };
static_assert(F::kWeight.width() == F::kFactor.width());
static_assert(!Mixes<Fixed<F::kWeight>, Fixed<F::kFactor>>);
static_assert(!Mixes<Fixed<F::kLevelOfDetail>, Fixed<F::kWeight>>);
static_assert(Mixes<Fixed<F::kWeight>, Fixed<F::kWeight>>);
// No number becomes a Fixed, nor a Fixed a number, unsaid.
template <typename A>
concept TakesNumbers = requires(A a) {
  a = 1;
}
|| requires(A a) { a + a; };
static_assert(!TakesNumbers<Fixed<F::kWeight>>);

TEST(format, ranges_and_values) {
  constexpr Format kLevel = F::kLevelOfDetail;  // S5.8
  EXPECT_EQ(kLevel.width(), 14);
  EXPECT_EQ(kLevel.max_raw(), 8191);
  EXPECT_EQ(kLevel.min_raw(), -8192);
  EXPECT_EQ(kLevel.one(), 256);
  EXPECT_EQ(kLevel.value(-128), -0.5);
  EXPECT_EQ(Fixed<kLevel>::saturate(100000).raw(), 8191);
  EXPECT_EQ(Fixed<kLevel>::saturate(-100000).raw(), -8192);
  EXPECT_EQ(F::kWeight.min_raw(), 0);
}

TEST(format, bits_for_counts) {
  EXPECT_EQ(bits_for(2), 1);
  EXPECT_EQ(bits_for(15), 4);
  EXPECT_EQ(bits_for(16), 4);
  EXPECT_EQ(bits_for(17), 5);
}

TEST(format, names_are_unique) {
  std::set<std::string> names;
  for (const Format& format : F::kSet.all()) {
    EXPECT_TRUE(names.insert(std::string(format.name.view())).second) << format.name.view();
    EXPECT_GT(format.width(), 0) << format.name.view();
    EXPECT_LE(format.width(), 62) << format.name.view();
  }
}

TEST(format_death, overflow_ends_the_program) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(Fixed<F::kWeight>::from_raw(512), "raw value 512 does not fit format weight \\(U1.8\\)");
  EXPECT_DEATH(Fixed<F::kWeight>::from_raw(-1), "raw value -1 does not fit format weight");
  EXPECT_DEATH(Fixed<F::kMantissa>::from_raw(128), "raw value 128 does not fit format mantissa \\(S7.0\\)");
  EXPECT_DEATH(Fixed<F::kMantissa>::from_raw(-129), "mantissa");
  EXPECT_EQ(Fixed<F::kMantissa>::from_raw(-128).raw(), -128);
}

}  // namespace
}  // namespace feline
