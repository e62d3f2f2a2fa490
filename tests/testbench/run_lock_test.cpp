// SPDX-License-Identifier: Apache-2.0
#include "testbench/run_lock.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

TEST(run_lock, is_held_by_one_at_a_time) {
  const TempDir directory;
  const auto file = directory / "lock";
  std::optional<RunLock> lock(std::in_place, file);
  const std::string message = input_error([&] { const RunLock other(file); });
  EXPECT_NE(message.find("one run at a time"), std::string::npos) << message;
  lock.reset();
  EXPECT_NO_THROW(RunLock{file});
}

TEST(run_lock, tells_where_it_cannot_be) {
  const std::string message = input_error([] { const RunLock lock("/nonexistent/lock"); });
  EXPECT_NE(message.find("/nonexistent/lock"), std::string::npos) << message;
}

}  // namespace
}  // namespace feline
