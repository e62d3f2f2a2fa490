// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbench/prune/profile.h"

namespace feline {

// Makes the directory of a unit; throws InputError naming `--output` or a file that cannot be written there.
void prepare_unit(const std::filesystem::path& directory);

// The unit and what it was made from, in a directory that testbench/prune/build.sh takes. The verdict on a unit that
// was there, prune.json, is removed.
void write_unit(const std::filesystem::path& directory, const Config& config, const Profile& profile);

// Builds a program of a unit that `feline prune` wrote to `directory`, by testbench/prune/build.sh of the project's
// sources, and runs it; gives the JSON that it prints, whether what it checks holds or not. `target` is feline_pruned
// or feline_activity. Throws InputError when the sources or the unit are not there, or for the program's own exit code
// 2; std::runtime_error when the build fails.
nlohmann::ordered_json run_unit_program(const std::string& source, const std::string& directory,
                                        const std::string& target, const std::vector<std::string>& arguments);

}  // namespace feline
