// SPDX-License-Identifier: Apache-2.0
// The generated C header, as a driver or a firmware includes it.
#include <gtest/gtest.h>

#include "tables/generated/feline_roms.h"
#include "tables/roms.h"

namespace feline {
namespace {

template <std::size_t kWords>
void expect_words(const std::uint32_t (&words)[kWords], const Rom& rom) {
  ASSERT_EQ(kWords, rom.words.size()) << rom.name;
  for (std::size_t i = 0; i < kWords; ++i) EXPECT_EQ(words[i], rom.words[i]) << rom.name << " word " << i;
}

TEST(c_header, holds_the_words) {
  const Roms& machine = roms<kDefaultConfig>();
  expect_words(FELINE_ROM_ELLIPSE, machine.ellipse);
  expect_words(FELINE_ROM_WEIGHT, machine.weight);
  expect_words(FELINE_ROM_GAUSSIAN, machine.gaussian);
  expect_words(FELINE_ROM_LOG2, machine.log2);
  expect_words(FELINE_ROM_RECIPROCAL, machine.reciprocal);
  expect_words(FELINE_ROM_SRGB, machine.srgb);
  EXPECT_EQ(FELINE_TABLE_ROWS * FELINE_TABLE_COLUMNS, 256);
  EXPECT_EQ(FELINE_WEIGHT_COLUMNS, 9);
}

}  // namespace
}  // namespace feline
