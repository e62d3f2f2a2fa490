// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <type_traits>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/scenes/scene.h"
#include "testbench/text_number.h"

namespace feline {
namespace {

template <typename Value>
CLI::Validator range(Value least, Value most) {
  const std::string legal = fmt::format("{} to {}", least, most);
  return {[=](std::string& text) {
            const auto value = number_of<Value>(text);
            // CLI11 would read 010 as 8.
            if (std::is_integral_v<Value> && text.size() > 1 && text.front() == '0') {
              return fmt::format("got {}, legal is {}, without leading zeros", text, legal);
            }
            // Written so that NaN fails.
            const bool holds = value && *value >= least && *value <= most;
            return holds ? std::string() : fmt::format("got {}, legal is {}", text, legal);
          },
          legal};
}

}  // namespace

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) { return range(least, most); }

CLI::Validator number(double least, double most) { return range(least, most); }

CLI::Validator float32() {
  return {[](std::string& text) {
            return number_of<float>(text) ? std::string()
                                          : fmt::format("got {}, legal is a float32 number, inf or nan", text);
          },
          "float32"};
}

std::vector<std::string> split_list(const std::string& option, const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    std::string part = text.substr(at, comma - at);
    if (part.empty() || std::ranges::find(parts, part) != parts.end()) {
      bad_input("command line", option, text, "names with a comma between, each once");
    }
    parts.push_back(std::move(part));
    at = comma + 1;
  }
  return parts;
}

std::vector<const Scene*> scene_list(const std::string& text) {
  std::vector<const Scene*> chosen;
  if (text == "all") {
    for (const Scene& scene : scenes()) chosen.push_back(&scene);
    return chosen;
  }
  for (const std::string& name : split_list("--scene", text)) chosen.push_back(&find_scene(name));
  return chosen;
}

std::size_t parse_name(const std::string& option, const std::string& value, std::span<const std::string_view> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == value) return i;
  }
  bad_input("command line", option, value, fmt::format("one of {}", fmt::join(names, ", ")));
}

std::optional<NumberRange> parse_range(const std::string& text, std::uint64_t count) {
  NumberRange range;
  const char* const end = text.data() + text.size();
  auto [at, error] = std::from_chars(text.data(), end, range.first);
  range.last = range.first;
  if (error == std::errc{} && at != end && *at == ':') {
    const auto second = std::from_chars(at + 1, end, range.last);
    at = second.ptr;
    error = second.ec;
  }
  if (error != std::errc{} || at != end || range.last < range.first || range.last >= count) return std::nullopt;
  return range;
}

void prepare_directory(const std::string& directory, std::initializer_list<std::string_view> names) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) bad_input(directory, "--output", error.message(), "a directory, or where one can be made");
  for (const std::string_view name : names) check_writable(std::filesystem::path(directory) / name);
}

void refuse_empty(std::span<const std::string> arguments) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument.empty()) bad_input("command line", arguments[i - 1], "an empty value", "a value");
    if (argument.starts_with("--") && argument.ends_with("=")) {
      bad_input("command line", argument.substr(0, argument.size() - 1), "an empty value", "a value");
    }
  }
}

void refuse_given(std::span<const CLI::Option* const> options, std::string_view why) {
  for (const CLI::Option* option : options) {
    if (option->count() == 0) continue;
    bad_input("command line", option->get_name(), fmt::format("{}", fmt::join(option->results(), ",")),
              fmt::format("nothing {}", why));
  }
}

std::string quoted(const std::string& argument) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+-";
  if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string::npos) return argument;
  std::string safe = "'";
  for (const char c : argument) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

std::vector<std::string> arguments_without(std::span<const std::string> arguments, const LeftOut& left_out) {
  const auto among = [](std::span<const std::string_view> names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view argument = arguments[i];
    if (among(left_out.flags, argument)) continue;
    if (among(left_out.options, argument)) {
      ++i;
    } else if (!among(left_out.options, argument.substr(0, argument.find('=')))) {
      kept.push_back(arguments[i]);
    }
  }
  return kept;
}

std::string repeat_command(std::span<const std::string> arguments, const LeftOut& left_out) {
  std::string command = quoted(arguments.front());
  for (const std::string& argument : arguments_without(arguments.subspan(1), left_out))
    command += " " + quoted(argument);
  return command;
}

}  // namespace feline
