// SPDX-License-Identifier: Apache-2.0
#include "testbench/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "testbench/error.h"

namespace feline {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& named, std::string_view field, int error) {
  bad_input(named.string(), field, std::generic_category().message(error), "a writable file on a disk with room");
}

// Closes on every path; close() reports the errors that a destructor would lose.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags, const fs::path& named)
      : named_(named), fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (fd_ < 0) fail(named_, "open", errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }

  void write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(named_, "write", errno);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
  }

  void flush() {
    if (::fsync(fd_) != 0) fail(named_, "flush", errno);
  }

  void close() {
    if (::close(std::exchange(fd_, -1)) != 0) fail(named_, "close", errno);
  }

 private:
  fs::path named_;
  int fd_;
};

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

bool is_special(const fs::path& target) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// The file behind a symbolic link, so that the rename replaces the file and not the link.
fs::path resolve(fs::path target) {
  constexpr int kMostLinks = 40;  // as the system follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(target, error); ++i) {
    // An absolute link replaces the whole path.
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  return target;
}

// Unique in this process by the counter, between processes by the id; O_EXCL does the rest.
fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  return target.parent_path() /
         fmt::format(".{}.{}-{}{}", target.stem().string(), ::getpid(), counter++, target.extension().string());
}

// The names of the temporaries that exist, for a signal handler, which may neither lock nor allocate. More than there
// is room for are not remembered.
constexpr std::size_t kSlots = 4096;
std::array<std::atomic<char*>, kSlots> temporaries;

std::size_t remember(const fs::path& path) {
  char* const name = ::strdup(path.c_str());
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    char* none = nullptr;
    if (temporaries[slot].compare_exchange_strong(none, name)) return slot;
  }
  std::free(name);
  return kSlots;
}

void forget(std::size_t slot) {
  if (slot < kSlots) std::free(temporaries[slot].exchange(nullptr));
}

extern "C" void remove_temporaries(int signal) {
  for (auto& name : temporaries) {
    if (const char* const path = name.load()) ::unlink(path);
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

void remove_temporaries_when_killed() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, remove_temporaries);
}

AtomicFile::AtomicFile(const fs::path& target)
    : named_(target), target_(resolve(target)), temporary_(temporary_name(target_)) {
  if (target.filename().empty() || fs::is_directory(target_)) {
    bad_input(named_.string(), "output", "a directory", "the path of a file");
  }
  if (is_special(target_)) {
    bad_input(named_.string(), "output", "a device or a pipe", "the path of a regular file");
  }
  slot_ = remember(temporary_);
  Descriptor(temporary_, O_WRONLY | O_CREAT | O_EXCL, named_).close();
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) fs::remove(temporary_, ignored);
  forget(slot_);
}

void AtomicFile::flush() {
  Descriptor file(temporary_, O_WRONLY, named_);
  file.flush();
  file.close();
}

void AtomicFile::rename() {
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) fail(named_, "rename", error.value());
  committed_ = true;
}

void AtomicFile::commit() {
  flush();
  rename();
}

// The temporary beside the target, or nothing for a device; what is written goes through a buffer.
struct OutputFiles::File::Parts {
  explicit Parts(const fs::path& target)
      : temporary(is_special(target) ? nullptr : std::make_unique<AtomicFile>(target)),
        out(std::in_place, temporary ? temporary->temporary() : target, O_WRONLY, target) {}

  std::unique_ptr<AtomicFile> temporary;
  std::optional<Descriptor> out;  // none once closed
  std::vector<std::byte> buffer;
};

OutputFiles::File::File(const fs::path& target) : parts_(std::make_unique<Parts>(target)) {}
OutputFiles::File::~File() = default;

void OutputFiles::File::append(std::span<const std::byte> bytes) {
  constexpr std::size_t kBlock = 1 << 20;
  parts_->buffer.insert(parts_->buffer.end(), bytes.begin(), bytes.end());
  if (parts_->buffer.size() < kBlock) return;
  parts_->out->write(parts_->buffer);
  parts_->buffer.clear();
}

void OutputFiles::File::append(std::string_view text) { append(bytes_of(text)); }

void OutputFiles::File::close() {
  if (!parts_->out) return;
  parts_->out->write(parts_->buffer);
  parts_->out->close();
  parts_->out.reset();
  parts_->buffer = {};
}

OutputFiles::File& OutputFiles::add(const fs::path& target) {
  files_.push_back(std::unique_ptr<File>(new File(target)));
  return *files_.back();
}

void OutputFiles::write(const fs::path& target, std::span<const std::byte> bytes) {
  File& file = add(target);
  file.append(bytes);
  file.close();
}

void OutputFiles::write(const fs::path& target, std::string_view text) { write(target, bytes_of(text)); }

void OutputFiles::commit() {
  for (const auto& file : files_) file->close();
  for (const auto& file : files_) {
    if (file->parts_->temporary) file->parts_->temporary->flush();
  }
  for (const auto& file : files_) {
    if (file->parts_->temporary) file->parts_->temporary->rename();
  }
  files_.clear();
}

void check_writable(const fs::path& target) {
  if (is_special(target)) {
    // Not by opening it: the reader of a pipe would see its end.
    if (::access(target.c_str(), W_OK) != 0) fail(target, "open", errno);
  } else {
    const AtomicFile probe(target);
  }
}

void write_file_atomically(const fs::path& target, std::span<const std::byte> bytes) {
  OutputFiles one;
  one.write(target, bytes);
  one.commit();
}

void write_file_atomically(const fs::path& target, std::string_view text) {
  write_file_atomically(target, bytes_of(text));
}

}  // namespace feline
