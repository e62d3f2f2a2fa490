// SPDX-License-Identifier: Apache-2.0
#include "testbench/text_file.h"

#include <fstream>
#include <iterator>

#include "testbench/error.h"

namespace feline {

std::string read_text(const std::filesystem::path& path, std::string_view field, std::string_view legal) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    bad_input(path.string(), field, "no file that can be read", legal);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) bad_input(path.string(), "write", "an error", "room in the temporary directory");
}

}  // namespace feline
