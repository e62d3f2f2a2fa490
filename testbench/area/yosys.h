// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "testbench/page/process.h"

namespace feline {

// Runs Yosys, or its abc. `needs_it` is who, for the message: "areas need it". Throws InputError, which says what to
// install, when it is not there.
page::Finished run_yosys(const std::vector<std::string>& arguments, std::string_view needs_it);
page::Finished run_abc(const std::string& commands, std::string_view needs_it);

// "Yosys 0.23".
std::string yosys_version(std::string_view needs_it);

}  // namespace feline
