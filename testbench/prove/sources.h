// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace feline::prove {

// What is proved, and by what: the RTL with its generated package and ROMs, the wrappers of leaves, the proofs, and the
// C++ that evaluates leaves, by their paths from the project's root.
using Sources = std::map<std::string, std::string, std::less<>>;

// Throws InputError naming `--source` for a directory that lacks one of these.
Sources read_sources(const std::filesystem::path& root);

// Those that this program was built from (embed_sources.cmake).
const Sources& built_in_sources();

// The C++ that evaluates a stage's leaves and their errors: the model's, exact arithmetic, what brings their fields to
// them, and all that these include. `text_of` gives a file's text.
std::set<std::string> evaluating_files(std::string_view stage,
                                       const std::function<const std::string&(const std::string& file)>& text_of);

}  // namespace feline::prove
