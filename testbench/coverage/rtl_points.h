// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/coverage/point.h"

namespace feline::coverage {

// What Verilator 5 writes, a line a point: "C '\1key\2value\1key\2value' count". Names are those of instances below the
// unit: "u_group.status[2]" for a bit, "u_group/else: the line's text" for a block or branch. Files are relative to
// the sources' root. Blocks that are entered without a condition are no points. Throws InputError naming the file, its
// line and what is wrong there.
std::vector<Point> read_rtl_points(const std::filesystem::path& file, SourceText& sources);

}  // namespace feline::coverage
