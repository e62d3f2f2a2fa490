// SPDX-License-Identifier: Apache-2.0
#include "testbench/run_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "testbench/error.h"

namespace feline {

RunLock::RunLock(const std::filesystem::path& file)
    : file_(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) bad_input(file.string(), "open", std::strerror(errno), "a file that can be written");
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    ::close(file_);
    if (error != EWOULDBLOCK) bad_input(file.string(), "lock", std::strerror(error), "a file that can be locked");
    bad_input(file.string(), "lock", "a run that is still going on", "one run at a time in a directory");
  }
}

RunLock::~RunLock() { ::close(file_); }

}  // namespace feline
