// SPDX-License-Identifier: Apache-2.0
#include "testbench/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace feline {
namespace {

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

// A file descriptor that is closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  int get() const { return value_; }
  bool open() const { return value_ >= 0; }
  void close() {
    if (value_ >= 0) ::close(value_);
    value_ = -1;
  }

 private:
  int value_;
};

// Both ends of a stream. A socket: what is sent to a program that has ended is then an error and no signal.
struct Stream {
  Stream() : Stream(pair()) {}
  Descriptor ours;
  Descriptor theirs;

 private:
  explicit Stream(const std::array<int, 2>& ends) : ours(ends[0]), theirs(ends[1]) {}
  static std::array<int, 2> pair() {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail(errno, "socketpair");
    return ends;
  }
};

// What can be read now; closes at the end.
void take(Descriptor& from, std::string& text) {
  std::array<char, 65536> buffer{};
  const ssize_t count = ::read(from.get(), buffer.data(), buffer.size());
  if (count > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  } else if (count == 0 || errno != EINTR) {
    from.close();
  }
}

// What can be written now; closes when all is, or nobody reads it.
void give(Descriptor& to, std::string_view& text) {
  const ssize_t count = ::send(to.get(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
  const bool later = count < 0 && (errno == EINTR || errno == EAGAIN);
  if (text.empty() || (count < 0 && !later)) to.close();
}

}  // namespace

Finished run_process(const std::vector<std::string>& command, std::string_view input) {
  Stream in;
  Stream out;
  Stream errors;
  std::vector<char*> arguments;
  // The interface is older than const; nothing is written there.
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.theirs.get(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.theirs.get(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.theirs.get(), STDERR_FILENO);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(error, command.front());
  in.theirs.close();
  out.theirs.close();
  errors.theirs.close();

  Finished finished;
  if (input.empty()) in.ours.close();
  while (out.ours.open() || errors.ours.open()) {
    // A negative descriptor is passed over.
    std::array<pollfd, 3> ready{
        {{in.ours.get(), POLLOUT, 0}, {out.ours.get(), POLLIN, 0}, {errors.ours.get(), POLLIN, 0}}};
    if (::poll(ready.data(), ready.size(), -1) < 0) continue;
    if (ready[0].revents != 0) give(in.ours, input);
    if (ready[1].revents != 0) take(out.ours, finished.output);
    if (ready[2].revents != 0) take(errors.ours, finished.errors);
  }
  in.ours.close();
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  finished.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return finished;
}

}  // namespace feline
