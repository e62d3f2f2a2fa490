// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "testbench/process.h"

namespace feline {

// Runs Yosys, or its abc. `needs_it` is who, for the message: "areas need it". Throws InputError, which says what to
// install, when it is not there.
Finished run_yosys(const std::vector<std::string>& arguments, std::string_view needs_it);
// Of abc, no longer than so many seconds if they are given; the exit code is then kOutOfTime.
inline constexpr int kOutOfTime = 124;
Finished run_abc(const std::string& commands, std::string_view needs_it, std::optional<int> seconds = {});

// "Yosys 0.23".
std::string yosys_version(std::string_view needs_it);

}  // namespace feline
