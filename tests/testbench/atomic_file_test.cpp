// SPDX-License-Identifier: Apache-2.0
#include "testbench/atomic_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

namespace fs = std::filesystem;

// The largest file of this process while the object lives: a disk that is full after some bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    rlimit limit = old_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    ::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

TEST(atomic_file, writes_and_replaces) {
  const TempDir dir;
  write_file_atomically(dir / "a.txt", "first");
  EXPECT_EQ(read_bytes(dir / "a.txt"), "first");
  write_file_atomically(dir / "a.txt", "second, longer");
  EXPECT_EQ(read_bytes(dir / "a.txt"), "second, longer");
  write_file_atomically(dir / "a.txt", "");
  EXPECT_EQ(read_bytes(dir / "a.txt"), "");
  EXPECT_EQ(dir.file_count(), 1);
}

TEST(atomic_file, bare_name_goes_to_the_working_directory) {
  const TempDir dir;
  const fs::path before = fs::current_path();
  fs::current_path(dir / "");
  write_file_atomically("bare.txt", "here");
  fs::current_path(before);
  EXPECT_EQ(read_bytes(dir / "bare.txt"), "here");
}

TEST(atomic_file, permissions_follow_the_umask) {
  const TempDir dir;
  const mode_t mask = ::umask(022);
  write_file_atomically(dir / "a.txt", "x");
  ::umask(mask);
  EXPECT_EQ(fs::status(dir / "a.txt").permissions(), fs::perms{0644});
}

TEST(atomic_file, symbolic_link_stays_a_link) {
  const TempDir dir;
  write_bytes(dir / "real.txt", "old");
  fs::create_symlink(dir / "real.txt", dir / "link.txt");
  write_file_atomically(dir / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(dir / "link.txt"));
  EXPECT_EQ(read_bytes(dir / "real.txt"), "new");
}

TEST(atomic_file, missing_directory) {
  const TempDir dir;
  const fs::path target = dir / "none/a.txt";
  EXPECT_EQ(input_error([&] { write_file_atomically(target, "x"); }),
            target.string() + ": open: got No such file or directory, legal is a writable file on a disk with room");
}

TEST(atomic_file, unwritable_directory) {
  const TempDir dir;
  fs::create_directory(dir / "locked");
  fs::permissions(dir / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  // Root may write anywhere; /proc refuses new files even to root.
  const fs::path target = ::geteuid() == 0 ? fs::path("/proc/a.txt") : dir / "locked/a.txt";
  const std::string message = input_error([&] { write_file_atomically(target, "x"); });
  EXPECT_EQ(message.find(target.string() + ": open: got "), 0u) << message;
  EXPECT_FALSE(fs::exists(target));
}

TEST(atomic_file, directory_as_target) {
  const TempDir dir;
  fs::create_directory(dir / "sub");
  EXPECT_EQ(input_error([&] { write_file_atomically(dir / "sub", "x"); }),
            (dir / "sub").string() + ": output: got a directory, legal is the path of a file");
  EXPECT_EQ(dir.file_count(), 1);
}

TEST(atomic_file, full_device) {
  EXPECT_EQ(input_error([] { write_file_atomically("/dev/full", "x"); }),
            "/dev/full: write: got No space left on device, legal is a writable file on a disk with room");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(atomic_file, full_disk_leaves_nothing) {
  const TempDir dir;
  write_bytes(dir / "a.bin", "as before");
  std::string message;
  {
    const FileSizeLimit limit(4096);
    message = input_error([&] { write_file_atomically(dir / "a.bin", std::string(10000, 'x')); });
  }
  EXPECT_EQ(message,
            (dir / "a.bin").string() + ": write: got File too large, legal is a writable file on a disk with room");
  EXPECT_EQ(read_bytes(dir / "a.bin"), "as before");
  EXPECT_EQ(dir.file_count(), 1);
}

TEST(atomic_file, temporary_is_beside_the_target) {
  const TempDir dir;
  AtomicFile file(dir / "wave.fst");
  EXPECT_EQ(file.temporary().extension(), ".fst");
  EXPECT_EQ(file.temporary().parent_path(), (dir / "wave.fst").parent_path());
  EXPECT_FALSE(fs::exists(dir / "wave.fst"));
  write_bytes(file.temporary(), "bits");
  file.commit();
  EXPECT_EQ(read_bytes(dir / "wave.fst"), "bits");
  EXPECT_FALSE(fs::exists(file.temporary()));
}

TEST(atomic_file, uncommitted_temporary_is_removed) {
  const TempDir dir;
  {
    const AtomicFile file(dir / "wave.fst");
    write_bytes(file.temporary(), "half");
    EXPECT_EQ(dir.file_count(), 1);
  }
  EXPECT_EQ(dir.file_count(), 0);
}

// All or none: the second of three cannot be written, and the first, which could, has not taken its name.
TEST(atomic_file, outputs_that_belong_together) {
  const TempDir dir;
  write_bytes(dir / "a.bin", "as before");
  std::string message;
  {
    const FileSizeLimit limit(4096);
    message = input_error([&] {
      OutputFiles outputs;
      outputs.write(dir / "a.bin", "new");
      outputs.write(dir / "b.bin", std::string(10000, 'x'));
      outputs.write(dir / "c.bin", "new");
      outputs.commit();
    });
  }
  EXPECT_EQ(message.find((dir / "b.bin").string() + ": write: got File too large"), 0U) << message;
  EXPECT_EQ(read_bytes(dir / "a.bin"), "as before");
  EXPECT_EQ(dir.file_count(), 1);
  OutputFiles outputs;
  outputs.write(dir / "a.bin", "new");
  OutputFiles::File& grown = outputs.add(dir / "b.bin");
  std::string expected;
  for (int i = 0; i < 300000; ++i) {
    grown.append("12345678");
    expected += "12345678";
  }
  EXPECT_EQ(read_bytes(dir / "a.bin"), "as before");
  outputs.commit();
  EXPECT_EQ(read_bytes(dir / "a.bin"), "new");
  EXPECT_EQ(read_bytes(dir / "b.bin"), expected);
  EXPECT_EQ(dir.file_count(), 2);
}

// More outputs than a process may have open files.
TEST(atomic_file, any_number_of_outputs) {
  const TempDir dir;
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit few{64, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  OutputFiles outputs;
  constexpr int kMany = 200;
  for (int i = 0; i < kMany; ++i) outputs.write(dir / (std::to_string(i) + ".txt"), "x");
  outputs.commit();
  EXPECT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(dir.file_count(), kMany);
}

TEST(atomic_file, link_to_nothing_makes_what_it_points_to) {
  const TempDir dir;
  fs::create_symlink("real.txt", dir / "link.txt");
  write_file_atomically(dir / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(dir / "link.txt"));
  EXPECT_EQ(read_bytes(dir / "real.txt"), "new");
}

TEST(atomic_file, check_before_the_work) {
  const TempDir dir;
  check_writable(dir / "a.txt");
  EXPECT_EQ(dir.file_count(), 0);
  check_writable("/dev/null");
  EXPECT_FALSE(input_error([&] { check_writable(dir / "none/a.txt"); }).empty());
}

TEST(atomic_file, device_cannot_be_renamed_over) {
  EXPECT_EQ(input_error([] { AtomicFile("/dev/null"); }),
            "/dev/null: output: got a device or a pipe, legal is the path of a regular file");
}

}  // namespace
}  // namespace feline
