// SPDX-License-Identifier: Apache-2.0
#include "testbench/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace feline {

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)),
      total_(total == 0 ? 1 : total),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (drawn_ != 0) fmt::print(stderr, "\r\033[K");
}

void Progress::advance(std::uint64_t done) {
  const std::uint64_t now_done = done_ += done;
  if (!terminal_) return;
  constexpr std::int64_t kPatience = 2000;
  constexpr std::int64_t kBetween = 200;
  const auto elapsed =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start_).count();
  std::int64_t before = drawn_;
  if (elapsed < kPatience || elapsed - before < kBetween || !drawn_.compare_exchange_strong(before, elapsed)) return;
  draw(now_done);
}

void Progress::draw(std::uint64_t done) {
  constexpr std::uint64_t kWidth = 40;
  const std::uint64_t full = std::min<std::uint64_t>(kWidth * done / total_, kWidth);
  fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {:3}%", what_, "", full, "", kWidth - full, 100 * done / total_);
  std::fflush(stderr);
}

}  // namespace feline
