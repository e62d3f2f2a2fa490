// SPDX-License-Identifier: Apache-2.0
#include "testbench/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

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

TEST(parallel, ends_soon_after_a_task_has_thrown) {
  std::atomic<int> begun{0};
  const auto run = [&] {
    for_each_index(0, 100000, [&](std::int64_t i) {
      ++begun;
      if (i == 0) throw std::runtime_error("task");
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    });
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_LT(begun, 50000);
}

TEST(parallel, a_task_may_have_tasks) {
  std::atomic<int> done{0};
  for_each_index(0, 10, [&](std::int64_t) { for_each_index(0, 10, [&](std::int64_t) { ++done; }); });
  EXPECT_EQ(done, 100);
}

}  // namespace
}  // namespace feline
