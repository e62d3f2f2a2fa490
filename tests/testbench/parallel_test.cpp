// SPDX-License-Identifier: Apache-2.0
#include "testbench/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>

namespace feline {
namespace {

TEST(parallel, does_each_once) {
  std::array<std::atomic<int>, 1000> done{};
  for_each_index(10, 1000, [&](std::int64_t i) { ++done[static_cast<std::size_t>(i)]; });
  for (std::size_t i = 0; i < done.size(); ++i) ASSERT_EQ(done[i], i < 10 ? 0 : 1) << i;
}

TEST(parallel, throws_what_a_task_throws) {
  for (const std::int64_t bad : {0, 499, 999}) {
    const auto run = [&] {
      for_each_index(0, 1000, [&](std::int64_t i) {
        if (i == bad) throw std::runtime_error("task");
      });
    };
    EXPECT_THROW(run(), std::runtime_error) << bad;
  }
}

}  // namespace
}  // namespace feline
