// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

namespace feline {

// A bar on standard error with the time left, if that is a terminal and the work has taken two seconds or is shown.
// Safe to advance from threads.
class Progress {
 public:
  Progress(std::string what, std::uint64_t total);
  // A part of the whole that has its own total and is worth `share` of the whole's, all of it at the latest when it
  // ends.
  Progress(Progress& whole, std::uint64_t share, std::uint64_t total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();
  void advance(std::uint64_t done);
  // Draws it now, for work that does not advance for long.
  void show();
  std::uint64_t done() const { return done_; }

 private:
  void pass_on(std::uint64_t done);
  void draw(std::uint64_t done, std::int64_t elapsed);

  Progress* whole_ = nullptr;
  std::uint64_t share_ = 0;
  std::string what_;
  std::uint64_t total_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<std::uint64_t> passed_on_{0};  // to the whole
  std::atomic<std::int64_t> drawn_{0};       // milliseconds after the start
};

}  // namespace feline
