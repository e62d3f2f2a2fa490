// SPDX-License-Identifier: Apache-2.0
#include "testbench/progress.h"

#include <gtest/gtest.h>

#include "testbench/parallel.h"

namespace feline {
namespace {

TEST(progress, a_part_passes_its_share_on) {
  Progress whole("testing", 100);
  {
    Progress part(whole, 40, 1000);
    part.advance(24);
    EXPECT_EQ(whole.done(), 0U);
    part.advance(1);
    EXPECT_EQ(whole.done(), 1U);
    part.advance(475);
    EXPECT_EQ(whole.done(), 20U);
  }
  EXPECT_EQ(whole.done(), 40U);
}

TEST(progress, a_part_gives_no_more_than_its_share) {
  Progress whole("testing", 100);
  {
    Progress part(whole, 40, 10);
    part.advance(25);
    EXPECT_EQ(whole.done(), 40U);
  }
  EXPECT_EQ(whole.done(), 40U);
  { const Progress nothing(whole, 0, 0); }
  EXPECT_EQ(whole.done(), 40U);
}

TEST(progress, threads_lose_nothing) {
  Progress whole("testing", 1000);
  {
    Progress part(whole, 500, 10000);
    for_each_index(0, 9990, [&](std::int64_t) { part.advance(1); });
    EXPECT_EQ(whole.done(), 499U);
  }
  EXPECT_EQ(whole.done(), 500U);
}

}  // namespace
}  // namespace feline
