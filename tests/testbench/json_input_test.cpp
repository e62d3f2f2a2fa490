// SPDX-License-Identifier: Apache-2.0
#include "testbench/json_input.h"

#include <gtest/gtest.h>

#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

using Json = nlohmann::ordered_json;

std::string refusal(const std::string& text) {
  return input_error([&] { parse_json(text, "a.json", "a file"); });
}

TEST(json_input, is_parsed) { EXPECT_EQ(parse_json(R"({"b": [1, {"a": 2}], "a": 3})", "", "")["b"][1]["a"], 2); }

TEST(json_input, other_text) {
  EXPECT_TRUE(refusal("{").starts_with("a.json: JSON: got"));
  EXPECT_TRUE(refusal("").ends_with("legal is a file"));
}

// The first would overflow the stack when it is copied or printed.
TEST(json_input, nesting) {
  for (const std::size_t depth : {std::size_t{1000000}, std::size_t{kMostNesting + 2}}) {
    EXPECT_TRUE(refusal(std::string(depth, '[')).starts_with("a.json: nesting: got deeper")) << depth;
  }
  EXPECT_NO_THROW(parse_json(std::string(kMostNesting, '[') + std::string(kMostNesting, ']'), "", ""));
}

TEST(json_input, fields_twice) {
  EXPECT_EQ(refusal(R"({"a": {"b": 1, "c": 2, "b": 1}})"), "a.json: b: got two values, legal is one");
  EXPECT_EQ(refusal(R"({"": 1, "": 2})"), "a.json: : got two values, legal is one");
  EXPECT_NO_THROW(parse_json(R"([{"a": {"a": 1}}, {"a": 1}])", "", ""));
}

TEST(json_input, whole_numbers) {
  EXPECT_EQ(whole_from_json<int>(Json(-5)), -5);
  EXPECT_EQ(whole_from_json<std::uint64_t>(Json(18446744073709551615U)), 18446744073709551615U);
  EXPECT_THROW(whole_from_json<int>(Json(1e300)), std::runtime_error);
  EXPECT_THROW(whole_from_json<int>(Json(1.0)), std::runtime_error);
  EXPECT_THROW(whole_from_json<int>(Json(true)), std::runtime_error);
  EXPECT_THROW(whole_from_json<int>(Json("1")), std::runtime_error);
  EXPECT_THROW(whole_from_json<int>(Json(2147483648)), std::runtime_error);
  EXPECT_THROW(whole_from_json<std::int64_t>(Json(9223372036854775808U)), std::runtime_error);
  EXPECT_THROW(whole_from_json<std::uint64_t>(Json(-1)), std::runtime_error);
}

}  // namespace
}  // namespace feline
