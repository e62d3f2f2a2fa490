// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/prune/profile.h"

namespace feline {

// What of one of kReachFacts is reached and what is not, in words.
struct ReachWords {
  const ReachFacts* of = nullptr;
  std::string reached;  // "table 75 %, simple 25 %" of what has names, otherwise "1 to 8, 12"; "nothing"
  std::string never;    // the legal rest; empty where all is reached, or where so much is legal that it says nothing
};
std::vector<ReachWords> reach_words(const Profile& profile);

// "0.25 %" of a whole; "-" of nothing.
std::string percent(std::uint64_t part, std::uint64_t whole);

// Lookups, probes and sources in a sentence.
std::string profile_headline(const Profile& profile);

// One line each: of a texture what was read, of everything else what is reached and what never.
std::string profile_to_text(const Profile& profile);

}  // namespace feline
