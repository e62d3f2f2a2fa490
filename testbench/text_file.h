// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace feline {

// Throws InputError naming the file, `field` and what would be legal.
std::string read_text(const std::filesystem::path& path, std::string_view field, std::string_view legal);
// A temporary file's contents. Throws InputError.
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace feline
