// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/coverage/point.h"

namespace feline::coverage {

// Points that nothing can reach, and why.
struct Exclusion {
  Kind kind = Kind::kRtlLine;
  std::string pattern;  // of names
  std::string reason;
  int line = 0;  // of the file
};

// A file of lines "KIND PATTERN -- REASON"; empty lines and those that begin with # say nothing. In a pattern * stands
// for any text, {a,b*,7..9} for any one of the patterns and numbers. Throws InputError naming the file, its line and
// what is wrong there.
std::vector<Exclusion> read_exclusions(const std::filesystem::path& file);

bool matches(std::string_view pattern, std::string_view name);

// Gives each point that a pattern names its reason. What is wrong with the exclusions, a line each: one that names no
// point, one that names a point that was reached.
std::vector<std::string> exclude(std::vector<Point>& points, const std::vector<Exclusion>& exclusions);

}  // namespace feline::coverage
