// SPDX-License-Identifier: Apache-2.0
#include "model/lookup.h"

#include <gtest/gtest.h>

#include <bit>

#include "tests/support/floats.h"

namespace feline {
namespace {

TEST(lookup, what_is_not_given_is_zero) {
  const auto request = make_request<kDefaultConfig>(Lookup{}, 0);
  EXPECT_EQ(request.s.raw(), 0);
  EXPECT_EQ(request.t.raw(), 0);
  EXPECT_EQ(request.dsdx.raw(), 0);
  EXPECT_EQ(request.dtdx.raw(), 0);
  EXPECT_EQ(request.dsdy.raw(), 0);
  EXPECT_EQ(request.dtdy.raw(), 0);
}

TEST(lookup, a_request_has_its_bits_and_as_many_of_the_tag_as_fit) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_lookup.request");
  for (int i = 0; i < 10000; ++i) {
    Lookup lookup;
    for (float* const operand : {&lookup.s, &lookup.t, &lookup.dsdx, &lookup.dtdx, &lookup.dsdy, &lookup.dtdy}) {
      *operand = any_float(random);
    }
    const std::int64_t tag = random.between(0, 1 << 20);
    const auto request = make_request<kDefaultConfig>(lookup, tag);
    EXPECT_EQ(request.tag.raw(), tag % 65536);
    EXPECT_EQ(request.s.raw(), std::bit_cast<std::uint32_t>(lookup.s));
    EXPECT_EQ(request.t.raw(), std::bit_cast<std::uint32_t>(lookup.t));
    EXPECT_EQ(request.dsdx.raw(), std::bit_cast<std::uint32_t>(lookup.dsdx));
    EXPECT_EQ(request.dtdx.raw(), std::bit_cast<std::uint32_t>(lookup.dtdx));
    EXPECT_EQ(request.dsdy.raw(), std::bit_cast<std::uint32_t>(lookup.dsdy));
    EXPECT_EQ(request.dtdy.raw(), std::bit_cast<std::uint32_t>(lookup.dtdy));
  }
}

}  // namespace
}  // namespace feline
