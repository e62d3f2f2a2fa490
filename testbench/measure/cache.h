// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace feline {

// Results of long work, kept in a directory under the hash of what they follow from, the program's own bytes included:
// what another build or other input left is never taken. Libraries and the machine are not part of it; times are those
// of the machine that measured them. Entries appear whole or not at all, and one that was
// damaged is as good as none.
class Cache {
 public:
  // Makes the directory; throws InputError when that is not possible. Entries of other builds stay until removed.
  explicit Cache(std::filesystem::path directory);
  // For results that follow from their parts alone, whatever build of this program makes them.
  static Cache of_parts(std::filesystem::path directory);

  // The key of a result that follows from these parts and, unless the cache is of parts, this program.
  std::string key(std::initializer_list<std::string_view> parts) const;

  std::optional<std::string> read(const std::string& key) const;
  void write(const std::string& key, std::string_view content) const;

 private:
  Cache(std::filesystem::path directory, std::string program);
  std::filesystem::path path(const std::string& key) const;
  std::filesystem::path directory_;
  std::string program_;
};

// The bytes of a file, as a part of a key. Throws InputError when it cannot be read.
std::string content_hash(const std::filesystem::path& file);

}  // namespace feline
