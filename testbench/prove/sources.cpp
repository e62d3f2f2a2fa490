// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

#include "tables/stages.h"
#include "testbench/error.h"
#include "testbench/text_file.h"

namespace feline::prove {
namespace {

constexpr std::string_view kLegal = "this project's sources";
constexpr std::string_view kModel = "model/";

// Of the project, by their paths from its root.
std::vector<std::string> included_files(std::string_view text) {
  constexpr std::string_view kInclude = "#include \"";
  std::vector<std::string> files;
  for (std::size_t at = text.find(kInclude); at != std::string_view::npos; at = text.find(kInclude, at)) {
    at += kInclude.size();
    files.emplace_back(text.substr(at, text.find('"', at) - at));
  }
  return files;
}

void read_modules(const std::filesystem::path& root, const std::string& directory, Sources& sources) {
  const std::size_t before = sources.size();
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(root / directory, none)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("feline_") || !name.ends_with(".sv")) continue;
    sources[fmt::format("{}/{}", directory, name)] = read_text(entry.path(), "--source", kLegal);
  }
  if (sources.size() == before) {
    bad_input(root.string(), "--source", fmt::format("no {}/feline_*.sv", directory), kLegal);
  }
}

}  // namespace

Sources read_sources(const std::filesystem::path& root) {
  Sources sources;
  for (const char* const directory :
       {"rtl", "tables/generated", "testbench/prove/rtl_leaves", "testbench/prove/proofs"}) {
    read_modules(root, directory, sources);
  }
  for (const std::string_view stage : kStageNames) {
    evaluating_files(stage, [&](const std::string& file) -> const std::string& {
      const auto [source, is_new] = sources.try_emplace(file);
      if (is_new) source->second = read_text(root / file, "--source", kLegal);
      return source->second;
    });
  }
  return sources;
}

std::set<std::string> evaluating_files(std::string_view stage,
                                       const std::function<const std::string&(const std::string& file)>& text_of) {
  constexpr std::array kFront{"group", "footprint", "plan"};
  const bool is_front = std::ranges::find(kFront, stage) != kFront.end();
  const std::string_view exact = stage == "plan" ? "plan" : is_front ? "footprint" : "texels";
  std::vector<std::string> waiting{fmt::format("model/{}.h", stage), fmt::format("testbench/prove/exact_{}.cpp", exact),
                                   "testbench/prove/exact_tables.cpp",
                                   fmt::format("testbench/prove/model_{}.cpp", is_front ? "front" : "back"),
                                   "testbench/prove/errors.cpp"};
  std::set<std::string> files;
  while (!waiting.empty()) {
    const std::string file = waiting.back();
    waiting.pop_back();
    if (!files.insert(file).second) continue;
    for (std::string& included : included_files(text_of(file))) {
      // What evaluates several stages includes all of their models: of those only the stage's own counts.
      const bool is_of_another = included.starts_with(kModel) && !file.starts_with(kModel);
      if (!is_of_another) waiting.push_back(std::move(included));
    }
  }
  return files;
}

}  // namespace feline::prove
