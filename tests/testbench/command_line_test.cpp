// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/command_line.h"

#include <gtest/gtest.h>

#include "tests/testbench/run_program.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

TEST(command_line, validators_name_what_is_legal) {
  const auto message = [](const CLI::Validator& validator, std::string text) { return validator(text); };
  EXPECT_EQ(message(whole_number(1, 16), "16"), "");
  for (const char* const wrong : {"17", "0", "-1", "1.5", "1x", "", " 1", "99999999999999999999"}) {
    EXPECT_EQ(message(whole_number(1, 16), wrong), std::string("got ") + wrong + ", legal is 1 to 16");
  }
  // CLI11 would take it for 14.
  EXPECT_EQ(message(whole_number(1, 16), "016"), "got 016, legal is 1 to 16, without leading zeros");
  EXPECT_EQ(message(whole_number(0, 16), "0"), "");
  EXPECT_EQ(message(number(-16, 15.5), "-1e-3"), "");
  for (const char* const wrong : {"15.6", "nan", "inf", "1,5", "abc", ""}) {
    EXPECT_EQ(message(number(-16, 15.5), wrong), std::string("got ") + wrong + ", legal is -16 to 15.5");
  }
}

TEST(command_line, lists) {
  EXPECT_EQ(split_list("--mode", "a,b,c"), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(split_list("--mode", "a"), std::vector<std::string>{"a"});
  for (const char* const wrong : {"", "a,", ",a", "a,,b", "a,b,a"}) {
    EXPECT_NE(input_error([&] { split_list("--mode", wrong); }).find("--mode: got " + std::string(wrong)),
              std::string::npos);
  }
}

TEST(command_line, repeats_without_what_is_left_out) {
  constexpr std::array<std::string_view, 2> kOptions{"--replay", "--scene"};
  constexpr std::array<std::string_view, 1> kFlags{"--json"};
  const auto repeat = [&](const std::vector<std::string>& arguments) {
    return repeat_command(arguments, {kOptions, kFlags});
  };
  EXPECT_EQ(repeat({"/any/where/feline", "cosim", "--scene", "a,b", "--size=64", "--json", "--replay=3"}),
            "/any/where/feline cosim --size=64");
  EXPECT_EQ(repeat({"feline", "cosim", "--scene=a", "--texture", "my photo's.png", "--replay", "3:9"}),
            "feline cosim --texture 'my photo'\\''s.png'");
  EXPECT_EQ(repeat({"feline"}), "feline");
}

// What is quoted comes through a shell as it was.
TEST(command_line, quotes_for_a_shell) {
  for (const std::string word : {"plain-1.png", "two words", "it's", "$HOME", "a\"b`c\\d", "*", "", "\t!#&|;<>()"}) {
    EXPECT_EQ(run_program("printf", "%s " + quoted(word)).text, word);
  }
}

}  // namespace
}  // namespace feline
