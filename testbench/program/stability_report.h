// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "testbench/stability/study.h"

namespace feline {

// Prints the study as text or JSON and, in a directory if one is named, writes its four files, all or none. The
// program's exit code: kBroken if a bound is broken. Throws InputError, without gnuplot as well.
int report_stability(const stability::Study& study, const std::filesystem::path& directory, bool as_json);

}  // namespace feline
