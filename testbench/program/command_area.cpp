// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>

#include "tables/stages.h"
#include "testbench/area/synthesis.h"
#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/progress.h"

namespace feline {
namespace {

struct AreaOptions {
  std::string source = FELINE_SOURCE_DIR;
  std::string generated;
  std::string stages;
  std::string library = kCellLibrary;
  std::string cache;
  bool json = false;
};

std::vector<std::string> stage_list(const std::string& text) {
  std::vector<std::string> all;
  for (const std::string_view name : kStageNames) all.emplace_back(name);
  all.emplace_back("spill");
  if (text == "all") return all;
  const std::vector<std::string_view> legal(all.begin(), all.end());
  std::vector<std::string> chosen = split_list("--stage", text);
  for (const std::string& name : chosen) parse_name("--stage", name, legal);
  return chosen;
}

int run_area(const AreaOptions& options) {
  const std::filesystem::path root = options.source;
  const std::vector<std::string> alone =
      options.stages.empty() ? std::vector<std::string>{} : stage_list(options.stages);
  const std::string source =
      unit_source(root / "rtl",
                  options.generated.empty() ? root / "tables" / "generated" : std::filesystem::path(options.generated));
  std::optional<Cache> cache;
  if (!options.cache.empty()) cache.emplace(options.cache);
  const Synthesis synthesis(options.library, cache ? &*cache : nullptr);
  std::vector<StageArea> stages;
  Progress progress("synthesizing", std::max<std::size_t>(1, alone.size()));
  progress.show();
  if (alone.empty()) stages = synthesis.unit(source);
  for (const std::string& name : alone) {
    stages.push_back(synthesis.stage(source, name));
    progress.advance(1);
  }
  const AreaReport report = synthesis.report(std::move(stages));
  fmt::print("{}", options.json ? to_json(report).dump(1) + "\n" : to_text(report));
  return kHolds;
}

}  // namespace

void add_area(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<AreaOptions>();
  CLI::App* command = program.add_subcommand("area", "synthesizes the unit: cells, area, multipliers of every stage");
  command->footer(
      "Of the unit as it is used: pins that only watch its stages are left out, and constants and what nobody needs\n"
      "go away across stages. The texel cache's memories are counted in bits; everything else, ROMs too, is in cells.\n"
      "Needs Yosys and OSU's 180 nm cells (Debian packages yosys, qflow-tech-osu018); takes about two minutes.\n"
      "Example: feline area --generated runway-unit/generated");
  command->add_option("--generated", options->generated,
                      "package and ROMs, as of feline prune; otherwise those of --source");
  command->add_option("--source", options->source, "this project's sources, with rtl/")->capture_default_str();
  command->add_option(
      "--stage", options->stages,
      "stages alone instead, with all that is on their ports: a list a,b, or all; spill is one of them");
  command->add_option("--library", options->library, "Liberty file of the cells")->capture_default_str();
  command->add_option("--cache", options->cache, "directory that keeps results for the next time");
  command->add_flag("--json", options->json, "also which multipliers, as JSON");
  command->callback([options, &exit_code] { exit_code = run_area(*options); });
}

}  // namespace feline
