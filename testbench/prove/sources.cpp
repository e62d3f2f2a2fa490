// SPDX-License-Identifier: Apache-2.0
#include "testbench/prove/sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "tables/stages.h"
#include "testbench/error.h"
#include "testbench/text_file.h"

namespace feline::prove {
namespace {

constexpr std::string_view kLegal = "this project's sources";

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
    for (const std::string& file : evaluating_files(stage)) {
      if (!sources.contains(file)) sources[file] = read_text(root / file, "--source", kLegal);
    }
  }
  return sources;
}

std::vector<std::string> evaluating_files(std::string_view stage) {
  constexpr std::array kFront{"group", "footprint", "plan"};
  const bool is_front = std::ranges::find(kFront, stage) != kFront.end();
  const std::string_view exact = stage == "plan" ? "plan" : is_front ? "footprint" : "texels";
  return {fmt::format("model/{}.h", stage),
          "model/features.h",
          "tables/rounding.h",
          fmt::format("testbench/prove/exact_{}.cpp", exact),
          "testbench/prove/exact_rounding.h",
          "testbench/prove/exact_tables.cpp",
          fmt::format("testbench/prove/model_{}.cpp", is_front ? "front" : "back"),
          "testbench/prove/leaves.h"};
}

}  // namespace feline::prove
