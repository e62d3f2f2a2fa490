// SPDX-License-Identifier: Apache-2.0
#include "testbench/process.h"

#include <gtest/gtest.h>

#include <system_error>

namespace feline {
namespace {

TEST(process, its_output_and_how_it_ended) {
  EXPECT_EQ(run_process({"cat"}, "text").output, "text");
  const std::string large(3'000'000, 'x');
  EXPECT_EQ(run_process({"cat"}, large).output, large);
  // It ends without reading; the input is lost and nothing else.
  const Finished early = run_process({"sh", "-c", "echo why >&2; exit 3"}, large);
  EXPECT_EQ(early.code, 3);
  EXPECT_EQ(early.errors, "why\n");
  EXPECT_EQ(run_process({"sh", "-c", "kill -9 $$"}, "").code, 128 + 9);
  EXPECT_THROW(run_process({"feline-no-such-program"}, ""), std::system_error);
}

}  // namespace
}  // namespace feline
