// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/coverage/point.h"

namespace feline::coverage {

// What `llvm-cov show -show-branches=count -show-instantiations=false` prints: the lines of files with their counts,
// and both sides of every branch, once for each instance of a template; they are added up. A condition that every
// instance knows when it is compiled is no branch. Names are "model/plan.h/true: the line's text from the branch on",
// "model/plan.h/the line's text". Throws InputError naming the file, its line and what is wrong there.
std::vector<Point> read_model_points(const std::filesystem::path& file, SourceText& sources);

}  // namespace feline::coverage
