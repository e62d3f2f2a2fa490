// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/cache.h"

#include <OpenImageIO/hash.h>
#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "testbench/atomic_file.h"
#include "testbench/error.h"

namespace feline {
namespace {

constexpr std::size_t kDigestLength = 40;

std::string digest(std::string_view bytes) {
  OIIO::SHA1 hash(bytes.data(), bytes.size());
  return hash.digest();
}

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

Cache::Cache(std::filesystem::path directory) : Cache(std::move(directory), content_hash("/proc/self/exe")) {}

Cache Cache::of_parts(std::filesystem::path directory) { return {std::move(directory), ""}; }

Cache::Cache(std::filesystem::path directory, std::string program)
    : directory_(std::move(directory)), program_(std::move(program)) {
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  if (!std::filesystem::is_directory(directory_)) {
    bad_input(directory_.string(), "cache", error ? error.message() : "no directory", "a directory that can be made");
  }
}

std::string Cache::key(std::initializer_list<std::string_view> parts) const {
  std::string all = program_;
  // With their lengths, so that no two lists of parts read alike.
  for (const std::string_view part : parts) all += fmt::format("{}:{}", part.size(), part);
  return digest(all);
}

std::filesystem::path Cache::path(const std::string& key) const { return directory_ / key; }

std::optional<std::string> Cache::read(const std::string& key) const {
  std::optional<std::string> stored = read_file(path(key));
  if (!stored || stored->size() < kDigestLength) return std::nullopt;
  std::string content = stored->substr(kDigestLength);
  if (stored->compare(0, kDigestLength, digest(content)) != 0) return std::nullopt;
  return content;
}

void Cache::write(const std::string& key, std::string_view content) const {
  write_file_atomically(path(key), digest(content) + std::string(content));
}

std::string content_hash(const std::filesystem::path& file) {
  const std::optional<std::string> bytes = read_file(file);
  if (!bytes) bad_input(file.string(), "open", "no file that can be read", "a file");
  return digest(*bytes);
}

}  // namespace feline
