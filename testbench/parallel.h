// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/parallel.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>

namespace feline {

// Calls task(i) for every i of first .. end - 1, on all processors, in any order. After one has thrown no other one
// begins, and what it threw is thrown.
template <typename Task>
void for_each_index(std::int64_t first, std::int64_t end, const Task& task) {
  std::atomic<bool> failed{false};
  std::mutex mutex;
  std::exception_ptr failure;
  // OpenImageIO would not split fewer than 1024 tasks, which are rows here; what they throw it drops.
  const OIIO::paropt options(0, OIIO::paropt::SplitDir::Y, 1);
  OIIO::parallel_for(
      first, end,
      [&](std::int64_t i) {
        if (failed) return;
        try {
          task(i);
        } catch (...) {
          const std::scoped_lock lock(mutex);
          if (!failed.exchange(true)) failure = std::current_exception();
        }
      },
      options);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace feline
