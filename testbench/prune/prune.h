// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tables/config.h"
#include "testbench/prune/profile.h"

namespace feline {

// The smallest configuration whose unit gives the full unit's pixels, colour and status, for every lookup of a profile
// taken from it. Whatever else comes is flagged as unsupported, or comes out as of the full unit. That is the default
// one, or one of other widths.
Config pruned_config(const Profile& profile, const Config& full = kDefaultConfig);

// Whether everything that a configuration needs is in another one: then whatever the first one's unit can do, the
// second one's can.
bool is_within(const Config& needed, const Config& available);

// How much of a part a configuration has, and the default one.
struct PartSize {
  std::string_view what;  // "size bits": log2 of the largest width and height
  int have = 0;
  int full = 0;
};
std::vector<PartSize> part_sizes(const Config& config);

// What the default configuration has and this one has not, a line each: "features: nearest, ext", "probes: 5 of 16".
std::vector<std::string> left_out(const Config& config);

// Every field by its name, but for the words of the ROMs.
nlohmann::ordered_json config_to_json(const Config& config);

// The header of a build for this unit (tables/unit.h): defines kUnit.
std::string unit_header(const Config& config);

}  // namespace feline
