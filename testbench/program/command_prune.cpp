// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/frames_profile.h"
#include "testbench/program/unit_program.h"
#include "testbench/prune/check.h"
#include "testbench/prune/profile_json.h"
#include "testbench/prune/prune.h"

namespace feline {
namespace {

struct PruneOptions {
  FrameOptions frames;
  std::vector<std::string> profiles;
  std::string output = "feline-unit";
  std::string source = FELINE_SOURCE_DIR;
  bool no_check = false;
  bool json = false;
  std::vector<std::string> frame_arguments;  // of the command line, for the check
};

int run_prune(const PruneOptions& options) {
  options.frames.check();
  Profile profile;
  for (const std::string& file : options.profiles) merge(profile, read_profile(file));
  if (!options.profiles.empty() && profile.lookups == 0) bad_input("--profile", "lookups", "0", "at least 1");
  const std::filesystem::path directory = options.output;
  prepare_unit(directory);
  prepare_directory(options.output, {"prune.json"});
  if (options.profiles.empty()) profile = profile_of(options.frames);
  const Config config = pruned_config(profile);
  write_unit(directory, config, profile);
  nlohmann::ordered_json json{
      {"profiled_lookups", profile.lookups}, {"left_out", left_out(config)}, {"configuration", config_to_json(config)}};
  bool holds = true;
  std::string text;
  for (const std::string& line : left_out(config)) text += fmt::format("left out  {}\n", line);
  if (options.no_check || !options.frames.given()) {
    json["check"] = nullptr;
    text += fmt::format("check     none: {}\n", options.no_check ? "--no-check" : "no frames to check the unit on");
  } else {
    const PrunedCheck check =
        check_from_json(run_unit_program(options.source, options.output, "feline_pruned", options.frame_arguments));
    const bool profiled_here = options.profiles.empty();
    holds = check.holds() && (!profiled_here || check.outside == 0);
    json["check"] = to_json(check);
    json["holds"] = holds;
    text += fmt::format(
        "check     {} lookups, {} identical to the full unit's, {} outside, {} flagged, {} refused by the driver, {} "
        "wrong without a flag, {} RTL mismatches\n{}",
        check.lookups, check.identical, check.outside, check.flagged, check.refused, check.silent, check.mismatches,
        check.message);
  }
  write_file_atomically(directory / "prune.json", json.dump(1) + "\n");
  if (options.json) {
    fmt::print("{}\n", json.dump(1));
  } else {
    fmt::print("{}{}\n", text, (directory / "prune.json").string());
  }
  return holds ? kHolds : kBroken;
}

}  // namespace

void add_prune(CLI::App& program, int& exit_code, const std::vector<std::string>& arguments) {
  auto options = std::make_shared<PruneOptions>();
  constexpr std::array<std::string_view, 3> kOptions{"--output", "--source", "--profile"};
  constexpr std::array<std::string_view, 2> kFlags{"--no-check", "--json"};
  constexpr std::size_t kProgramAndCommand = 2;
  if (arguments.size() > kProgramAndCommand) {
    options->frame_arguments = arguments_without(std::span(arguments).subspan(kProgramAndCommand), {kOptions, kFlags});
  }
  CLI::App* command = program.add_subcommand("prune", "the unit without what scenes do not need, checked on them");
  command->footer(
      "Writes unit.h, generated/ (package and ROMs), profile.json and prune.json, builds RTL and model of the unit,\n"
      "and compares its pixels with the full unit's. With --profile the frames given are held out: what leaves the\n"
      "profile must be flagged, and nothing may be wrong without a flag.\n"
      "Example: feline prune --scene runway --mode simple --output runway-unit");
  options->frames.add_to(*command);
  command
      ->add_option("--profile", options->profiles,
                   "profile.json to prune by, instead of the frames; may be given again")
      ->allow_extra_args(false);
  command->add_option("--output", options->output, "directory of the unit")->capture_default_str();
  command->add_option("--source", options->source, "this project's sources, to build the check from")
      ->capture_default_str();
  command->add_flag("--no-check", options->no_check, "write the unit, and do not build or run it");
  command->add_flag("--json", options->json, "print prune.json");
  command->callback([options, &exit_code] {
    if (!options->frames.given() && options->profiles.empty()) options->frames.choose_default_scene();
    exit_code = run_prune(*options);
  });
}

}  // namespace feline
