// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace feline::prove {

// What is proved, and by what: the RTL with its generated package and ROMs, the wrappers of leaves, the proofs, and the
// C++ that evaluates leaves, by their paths from the project's root.
using Sources = std::map<std::string, std::string, std::less<>>;

// Throws InputError naming `--source` for a directory that lacks one of these.
Sources read_sources(const std::filesystem::path& root);

// Those that this program was built from (embed_sources.cmake).
const Sources& built_in_sources();

// The C++ that evaluates a stage's leaves: the model's, exact arithmetic, and what brings their fields to them.
std::vector<std::string> evaluating_files(std::string_view stage);

}  // namespace feline::prove
