// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenImageIO/parallel.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

namespace feline {

// Calls task(i) for every i of first .. end - 1, on all processors, each taking the next that nobody has. After one has
// thrown no other one begins that can know, and what it threw is thrown.
template <typename Task>
void for_each_index(std::int64_t first, std::int64_t end, const Task& task) {
  std::atomic<std::int64_t> next{first};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&](std::int64_t) {
    for (std::int64_t i = next++; i < end; i = next++) {
      try {
        task(i);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!failure) failure = std::current_exception();
        next = end;
      }
    }
  };
  // OpenImageIO would not split fewer than 1024 tasks, gives each processor its share beforehand, and drops what they
  // throw.
  const OIIO::paropt options(0, OIIO::paropt::SplitDir::Y, 1);
  OIIO::parallel_for(std::int64_t{0}, std::int64_t{std::max(1U, std::thread::hardware_concurrency())}, work, options);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace feline
