// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/campaign.h"

#include <gtest/gtest.h>

namespace feline::prove {
namespace {

TEST(prove_campaign, shards) {
  EXPECT_EQ(parse_shard("3/8")->index, 3U);
  EXPECT_EQ(parse_shard("3/8")->count, 8U);
  const Shard thin = *parse_shard("5/18446744073709551615");
  for (std::uint64_t chunk = 0; chunk < 10; ++chunk) EXPECT_EQ(thin.has(chunk), chunk == 5);
  for (const char* const wrong :
       {"", "/", "3", "3/", "/8", "8/8", "0/0", "-1/8", "1/8/2", " 1/8", "1/8 ", "1.0/8", "0/18446744073709551616"}) {
    EXPECT_FALSE(parse_shard(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace feline::prove
