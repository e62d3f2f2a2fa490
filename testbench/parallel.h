// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/parallel.h>

#include <cstdint>

namespace feline {

// Calls task(i) for every i of first .. end - 1, on all processors, in any order. The task throws nothing.
template <typename Task>
void for_each_index(std::int64_t first, std::int64_t end, const Task& task) {
  // OpenImageIO would not split fewer than 1024 tasks, which are rows here.
  const OIIO::paropt options(0, OIIO::paropt::SplitDir::Y, 1);
  OIIO::parallel_for(
      first, end, [&](std::int64_t i) { task(i); }, options);
}

}  // namespace feline
