// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "testbench/prove/chunk.h"

namespace feline::prove {

// What a run has done so far, a line a chunk, each on the disk before the next: a line cut short by the end of the
// program or of the machine is as good as none. For one run at a time.
class Journal {
 public:
  // A chunk of a leaf whose modules have this hash.
  struct Entry {
    std::string leaf, sources;
    std::uint64_t chunk = 0;
    ChunkResult result;
  };

  // Calls `done` for each entry that the file holds; of another program it is begun anew. Throws InputError when it
  // cannot be written.
  Journal(const std::filesystem::path& file, const std::string& program, const std::function<void(const Entry&)>& done);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  // A chunk without mismatches; one with them is proved again, so that they are told again.
  void append(const Entry& entry);

 private:
  void write_line(const std::string& line);

  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace feline::prove
