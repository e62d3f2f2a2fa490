// SPDX-License-Identifier: Apache-2.0
#include "testbench/program/unit_program.h"

#include <fmt/format.h>

#include <stdexcept>

#include "tables/emit.h"
#include "testbench/atomic_file.h"
#include "testbench/error.h"
#include "testbench/process.h"
#include "testbench/program/command_line.h"
#include "testbench/program/commands.h"
#include "testbench/progress.h"
#include "testbench/prune/profile_json.h"
#include "testbench/prune/prune.h"

namespace feline {

void prepare_unit(const std::filesystem::path& directory) {
  prepare_directory(directory.string(), {"unit.h", "profile.json"});
  prepare_directory((directory / "generated").string(), {"feline_pkg.sv"});
}

void write_unit(const std::filesystem::path& directory, const Config& config, const Profile& profile) {
  OutputFiles outputs;
  outputs.write(directory / "unit.h", unit_header(config));
  outputs.write(directory / "profile.json", profile_to_json(profile));
  for (const GeneratedFile& file : generate(config, measured_roms(config))) {
    outputs.write(directory / "generated" / file.name, file.text);
  }
  // The verdict on another unit.
  std::filesystem::remove(directory / "prune.json");
  outputs.commit();
}

nlohmann::ordered_json run_unit_program(const std::string& source, const std::string& directory,
                                        const std::string& target, const std::vector<std::string>& arguments) {
  const std::filesystem::path script = std::filesystem::path(source) / "testbench" / "prune" / "build.sh";
  if (!std::filesystem::exists(script)) {
    bad_input(source, "--source", "no testbench/prune/build.sh in it", "this project's sources");
  }
  const std::filesystem::path unit = std::filesystem::absolute(directory);
  if (!std::filesystem::exists(unit / "unit.h")) {
    bad_input(directory, "unit", "no unit.h in it", "a directory of feline prune");
  }
  // About as long as each other.
  Progress progress("building and running the unit", 2);
  progress.show();
  const Finished built = run_process({script.string(), unit.string(), target}, "");
  if (built.code != 0) {
    throw std::runtime_error(
        fmt::format("{}: exit code {}\n{}{}", script.string(), built.code, built.output, built.errors));
  }
  progress.advance(1);
  std::vector<std::string> program{(unit / "build" / target).string()};
  program.insert(program.end(), arguments.begin(), arguments.end());
  const Finished finished = run_process(program, "");
  const std::string said = finished.errors.empty()
                               ? fmt::format("{}: exit code {}", target, finished.code)
                               : finished.errors.substr(0, finished.errors.find_last_not_of('\n') + 1);
  if (finished.code != kHolds && finished.code != kBroken) throw InputError(said);
  // Of a unit that was to be judged there is a verdict all the same.
  if (finished.code == kBroken && finished.output.empty()) throw WitnessMismatch(said);
  progress.advance(1);
  return nlohmann::ordered_json::parse(finished.output);
}

}  // namespace feline
