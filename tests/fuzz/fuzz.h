// SPDX-License-Identifier: Apache-2.0
// What the fuzz targets share. A target feeds an input to a parser, which may take it, and then what it gives must be
// as its header says, or refuse it with InputError. Anything else ends the program: libFuzzer keeps the input.
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "testbench/error.h"

namespace feline::fuzz {

// A contract: ends the program when it does not hold.
inline void require(bool holds, const char* contract) {
  if (holds) return;
  std::fprintf(stderr, "broken contract: %s\n", contract);
  std::abort();
}

// Calls `parse`; false when it refused with Refusal.
template <typename Refusal = InputError, typename Parse>
bool accepts(Parse parse) {
  try {
    parse();
  } catch (const Refusal&) {
    return false;
  }
  return true;
}

// An input: choices from its front, then the text or file to parse.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : rest_(reinterpret_cast<const char*>(data), size) {}

  // 0 to count - 1; 0 at the end of the input.
  std::size_t choose(std::size_t count) {
    if (rest_.empty()) return 0;
    const auto choice = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return choice % count;
  }
  template <typename Choice>
  Choice choose(std::span<const Choice> choices) {
    return choices[choose(choices.size())];
  }
  // Up to the separator, which is left out, or to the end.
  std::string_view part(char separator) {
    const std::string_view part = rest_.substr(0, rest_.find(separator));
    rest_.remove_prefix(std::min(part.size() + 1, rest_.size()));
    return part;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

// What a target does with an input: each defines its own.
void run(Input input);

// A directory of this process in that of temporary files; tests/fuzz.sh gives one that it removes.
inline const std::filesystem::path& directory() {
  static const std::filesystem::path made = [] {
    std::string name = (std::filesystem::temp_directory_path() / "feline-fuzz-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed: " + name);
    return std::filesystem::path(name);
  }();
  return made;
}

// The path of a file with these bytes, the same for the same name.
inline std::filesystem::path file_with(std::string_view name, std::string_view bytes) {
  std::filesystem::path path = directory() / name;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << bytes;
  if (!out.flush()) throw std::runtime_error("no room for " + path.string());
  return path;
}

}  // namespace feline::fuzz
