// SPDX-License-Identifier: Apache-2.0
#include "testbench/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace feline {

Progress::Progress(std::string what, std::uint64_t total)
    : what_(std::move(what)),
      total_(total == 0 ? 1 : total),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

Progress::Progress(Progress& whole, std::uint64_t share, std::uint64_t total)
    : whole_(&whole), share_(share), total_(total == 0 ? 1 : total), terminal_(false) {}

Progress::~Progress() {
  if (whole_ != nullptr) pass_on(total_);
  if (drawn_ != 0) fmt::print(stderr, "\r\033[K");
}

void Progress::advance(std::uint64_t done) {
  const std::uint64_t now_done = done_ += done;
  if (whole_ != nullptr) pass_on(now_done);
  if (!terminal_) return;
  constexpr std::int64_t kPatience = 2000;
  constexpr std::int64_t kBetween = 200;
  const auto elapsed =
      std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start_).count();
  std::int64_t before = drawn_;
  if (elapsed < kPatience || elapsed - before < kBetween || !drawn_.compare_exchange_strong(before, elapsed)) return;
  draw(now_done, elapsed);
}

void Progress::show() {
  if (!terminal_) return;
  drawn_ = 1;
  draw(done_, 0);
}

void Progress::pass_on(std::uint64_t done) {
  const std::uint64_t due = share_ * std::min(done, total_) / total_;
  std::uint64_t before = passed_on_;
  while (before < due && !passed_on_.compare_exchange_weak(before, due)) {
  }
  if (before < due) whole_->advance(due - before);
}

void Progress::draw(std::uint64_t done, std::int64_t elapsed) {
  constexpr std::uint64_t kWidth = 40;
  done = std::min(done, total_);
  const std::uint64_t full = kWidth * done / total_;
  const double part = static_cast<double>(done) / static_cast<double>(total_);
  const std::string left =
      done == 0 ? "" : fmt::format(", {:.0f} s left", static_cast<double>(elapsed) * (1 / part - 1) / 1000);
  fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {:3}%{}\033[K", what_, "", full, "", kWidth - full, 100 * done / total_,
             left);
  std::fflush(stderr);
}

}  // namespace feline
