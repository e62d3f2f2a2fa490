// SPDX-License-Identifier: Apache-2.0
// The values of options, each by its own function.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <set>

#include "testbench/program/command_line.h"
#include "testbench/prove/campaign.h"
#include "testbench/scenes/scene.h"
#include "tests/fuzz/fuzz.h"

namespace feline {
namespace {

void check_range(const std::string& text) {
  constexpr std::uint64_t kCount = 1000;
  const auto range = parse_range(text, kCount);
  if (!range) return;
  fuzz::require(range->first <= range->last && range->last < kCount, "parse_range: within the count");
  const auto again = parse_range(fmt::format("{}:{}", range->first, range->last), kCount);
  fuzz::require(again && again->first == range->first && again->last == range->last, "parse_range: FIRST:LAST");
}

void check_shard(const std::string& text) {
  const auto shard = prove::parse_shard(text);
  if (!shard) return;
  fuzz::require(shard->index < shard->count, "parse_shard: I < N");
  const auto again = prove::parse_shard(fmt::format("{}/{}", shard->index, shard->count));
  fuzz::require(again && again->index == shard->index && again->count == shard->count, "parse_shard: I/N");
}

void check_list(const std::string& text) {
  fuzz::accepts([&] {
    std::string joined;
    std::set<std::string> parts;
    for (const std::string& part : split_list("--list", text)) {
      fuzz::require(!part.empty() && parts.insert(part).second, "split_list: parts, each once");
      joined += (joined.empty() ? "" : ",") + part;
    }
    fuzz::require(joined == text, "split_list: all of the text");
  });
  fuzz::accepts([&] {
    const auto scenes = scene_list(text);
    fuzz::require(!scenes.empty() && std::ranges::find(scenes, nullptr) == scenes.end(), "scene_list: scenes");
  });
}

// What a validator takes, CLI11 takes for the same.
void check_whole_number(std::string text) {
  if (!whole_number(3, std::numeric_limits<std::uint64_t>::max())(text).empty()) return;
  std::uint64_t taken = 0;
  fuzz::require(CLI::detail::lexical_cast(text, taken) && std::to_string(taken) == text && taken >= 3, "whole_number");
}

void check_number(std::string text) {
  double taken = 0;
  if (number(-16, 15.5)(text).empty()) {
    fuzz::require(CLI::detail::lexical_cast(text, taken) && taken >= -16 && taken <= 15.5, "number: in its range");
  }
  if (float32()(text).empty()) {
    fuzz::require(CLI::detail::lexical_cast(text, taken), "float32: a number, inf or nan");
    fuzz::require(!std::isfinite(taken) || std::isfinite(static_cast<float>(taken)), "float32: finite is finite");
  }
}

// A shell's rules for what quoted() writes.
std::string unquoted(const std::string& text) {
  std::string plain;
  bool in_quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\'') {
      in_quotes = !in_quotes;
    } else {
      if (!in_quotes && text[i] == '\\') ++i;
      plain += text[i];
    }
  }
  return plain;
}

void check_arguments(fuzz::Input input) {
  constexpr std::array<std::string_view, 2> kOptions{"--scene", "--replay"};
  constexpr std::array<std::string_view, 1> kFlags{"--json"};
  std::vector<std::string> arguments{"feline"};
  while (!input.rest().empty()) arguments.emplace_back(input.part('\n'));
  for (const std::string& argument : arguments) {
    fuzz::require(unquoted(quoted(argument)) == argument, "quoted: the same for a shell");
  }
  const auto kept = arguments_without(arguments, {kOptions, kFlags});
  auto from = arguments.begin();
  for (const std::string& argument : kept) {
    from = std::find(from, arguments.end(), argument);
    fuzz::require(from++ != arguments.end(), "arguments_without: those that are left, in order");
  }
  fuzz::accepts([&] { refuse_empty(arguments); });
  repeat_command(arguments, {kOptions, kFlags});
}

}  // namespace
}  // namespace feline

void feline::fuzz::run(Input input) {
  const std::size_t kind = input.choose(6);
  const std::string text(input.rest());
  if (kind == 0) check_range(text);
  if (kind == 1) check_shard(text);
  if (kind == 2) check_list(text);
  if (kind == 3) check_whole_number(text);
  if (kind == 4) check_number(text);
  if (kind == 5) check_arguments(input);
}
