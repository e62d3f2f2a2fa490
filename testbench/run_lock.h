// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace feline {

// Held by one run at a time, and given back when it ends, however it does.
class RunLock {
 public:
  // Makes the file if it is not there. Throws InputError when that is not possible, or another run holds it.
  explicit RunLock(const std::filesystem::path& file);
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;
  ~RunLock();

 private:
  int file_ = -1;
};

}  // namespace feline
