// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace feline {

// Outputs appear whole or not at all: everything goes to a temporary file in the target's
// directory, which is flushed to the disk and then renamed over the target.

// A temporary path for a writer that wants a file name of its own (a trace, a library).
//   AtomicFile out("wave.fst");
//   writer.open(out.temporary());  ...  writer.close();
//   out.commit();
class AtomicFile {
 public:
  // Creates the temporary, empty. Throws InputError when the directory is missing or not
  // writable, or when the target is a directory or a device.
  explicit AtomicFile(const std::filesystem::path& target);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  // Removes the temporary unless it was committed.
  ~AtomicFile();

  // In the target's directory and with its extension.
  const std::filesystem::path& temporary() const { return temporary_; }

  // Flushes to the disk and renames. The writer has closed the file and checked its own
  // errors: bytes that it lost are not seen here. Throws InputError; the target is then as before.
  void commit();

 private:
  friend class OutputFiles;
  void flush();
  void rename();

  std::filesystem::path named_;   // as the user wrote it, for messages
  std::filesystem::path target_;  // symbolic links resolved
  std::filesystem::path temporary_;
  std::size_t slot_ = 0;
  bool committed_ = false;
};

// From now on a signal that ends the program (SIGINT, SIGTERM, SIGHUP) removes its temporaries first.
void remove_temporaries_when_killed();

// Several outputs that belong together: all of them are on the disk before the first takes its name,
// and none does if one cannot be written. A device or a pipe (/dev/full, /dev/stdout) is written in place,
// because renaming over it would replace it. Everything throws InputError naming the file and the
// system's reason: missing or unwritable directory, disk full, file too large.
class OutputFiles {
 public:
  class File {
   public:
    ~File();
    void append(std::span<const std::byte> bytes);
    void append(std::string_view text);

   private:
    friend class OutputFiles;
    struct Parts;
    explicit File(const std::filesystem::path& target);
    void close();
    std::unique_ptr<Parts> parts_;
  };

  // One more output, written as it grows; valid as long as this, open until commit.
  File& add(const std::filesystem::path& target);
  // One more output, all of it. Any number of them: none stays open.
  void write(const std::filesystem::path& target, std::span<const std::byte> bytes);
  void write(const std::filesystem::path& target, std::string_view text);
  void commit();

 private:
  std::vector<std::unique_ptr<File>> files_;
};

// Fails as an output would, before the work whose result it is.
void check_writable(const std::filesystem::path& target);

// One output of its own.
void write_file_atomically(const std::filesystem::path& target, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& target, std::string_view text);

}  // namespace feline
