// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/page/gnuplot.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/program/frames.h"
#include "testbench/program/frames_profile.h"
#include "testbench/prune/profile_json.h"
#include "testbench/prune/profile_page.h"
#include "testbench/prune/profile_text.h"

namespace feline {
namespace {

struct ProfileOptions {
  FrameOptions frames;
  std::vector<std::string> merged;
  std::string output;
  bool json = false;
};

int run_profile(const ProfileOptions& options) {
  options.frames.check();
  Profile profile;
  for (const std::string& file : options.merged) merge(profile, read_profile(file));
  const std::filesystem::path directory = options.output;
  if (!options.output.empty()) {
    page::check_gnuplot();
    prepare_directory(options.output, {"profile.json", "profile.html"});
  }
  if (options.frames.given()) merge(profile, profile_of(options.frames));
  const std::string json = profile_to_json(profile);
  if (!options.output.empty()) {
    OutputFiles outputs;
    outputs.write(directory / "profile.json", json);
    outputs.write(directory / "profile.html", profile_page(profile));
    outputs.commit();
  }
  fmt::print("{}", options.json ? json : profile_to_text(profile));
  if (!options.output.empty() && !options.json) fmt::print("{0}/profile.html\n{0}/profile.json\n", directory.string());
  return kHolds;
}

}  // namespace

void add_profile(CLI::App& program, int& exit_code) {
  auto options = std::make_shared<ProfileOptions>();
  CLI::App* command = program.add_subcommand("profile", "which parts of the unit scenes reach, and how often");
  command->footer(
      "Of a sequence one frame is in memory at a time. Profiles merge, so that a library of scenes is one profile.\n"
      "Example: feline profile --gbuffer frames/*.exr --texture photo.png --mode simple,table --output profile");
  options->frames.add_to(*command);
  command->add_option("--merge", options->merged, "profile.json files to add");
  command->add_option("--output", options->output, "directory for profile.html and profile.json");
  command->add_flag("--json", options->json, "print profile.json");
  command->callback([options, &exit_code] {
    if (!options->frames.given() && options->merged.empty()) options->frames.choose_default_scene();
    exit_code = run_profile(*options);
  });
}

}  // namespace feline
