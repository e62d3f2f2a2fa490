// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "testbench/process.h"

namespace feline {

// Runs a tool of this Debian package. `needs_it` is who, for the message: "areas need it". Throws InputError, which
// says what to install, when it is not there.
Finished run_tool(const std::vector<std::string>& command, std::string_view package, std::string_view needs_it);

}  // namespace feline
