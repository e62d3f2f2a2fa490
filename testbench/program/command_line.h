// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace feline {

struct Scene;

// Checks of an option's value, whose message is "got VALUE, legal is LEAST to MOST"; --help shows the range.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);
CLI::Validator number(double least, double most);
// The same for a float32 of any class: a number, inf or nan.
CLI::Validator float32();

// "a,b" to a and b; InputError naming the option for an empty item or one that is there twice.
std::vector<std::string> split_list(const std::string& option, const std::string& text);

// One of `names`, as its index; InputError naming the option, and all that is legal.
std::size_t parse_name(const std::string& option, const std::string& value, std::span<const std::string_view> names);

// Built-in scenes: a list a,b, or all. Throws InputError naming `--scene` and what is legal.
std::vector<const Scene*> scene_list(const std::string& text);

// "N" or "FIRST:LAST", 0 <= FIRST <= LAST < count; nothing for any other text.
struct NumberRange {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};
std::optional<NumberRange> parse_range(const std::string& text, std::uint64_t count);

// Makes a command's output directory, if need be, and checks that files of these names can be written there. Throws
// InputError naming `--output`, or the file.
void prepare_directory(const std::string& directory, std::initializer_list<std::string_view> names);

// Throws InputError for an argument that is empty: a script's variable that was never set.
void refuse_empty(std::span<const std::string> arguments);

// Throws InputError when one of the options was given: "nothing <why>" is legal.
void refuse_given(std::span<const CLI::Option* const> options, std::string_view why);

// For a shell: as it is, or in quotes.
std::string quoted(const std::string& argument);

// A command line again, the program as it was called, without some options and their values; flags have none.
struct LeftOut {
  std::span<const std::string_view> options;
  std::span<const std::string_view> flags;
};
std::vector<std::string> arguments_without(std::span<const std::string> arguments, const LeftOut& left_out);
std::string repeat_command(std::span<const std::string> arguments, const LeftOut& left_out);

}  // namespace feline
