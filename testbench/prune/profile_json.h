// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "testbench/prune/profile.h"

namespace feline {

// profile.json: version and configuration; sources, each with its frames; lookups and probes; for each of kReachFacts
// an object of value and count under part and name; textures by hash, each with names, format, width, height, levels,
// the runs of memory lines that were not and that were read, in turn and from line 0 on, and texels read of each block
// of level 0. Reading it gives the same profile again. Bytes of names that are no UTF-8 become U+FFFD.
std::string profile_to_json(const Profile& profile);

// `where` is named in messages. Throws InputError for everything that profile_to_json would not write: another version
// or configuration, fields missing, unknown or there twice, values out of range, counts that do not add up.
Profile profile_from_json(std::string_view text, std::string_view where);
Profile read_profile(const std::filesystem::path& path);

}  // namespace feline
