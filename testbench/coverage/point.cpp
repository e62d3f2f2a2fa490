// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/point.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <unordered_map>

#include "testbench/error.h"

namespace feline::coverage {

std::string SourceText::line(const std::string& file, int number, int column) {
  auto& lines = files_[file];
  if (lines.empty()) {
    std::ifstream in(root_ / file);
    for (std::string text; std::getline(in, text);) lines.push_back(text);
  }
  if (number < 1 || number > static_cast<int>(lines.size())) {
    bad_input((root_ / file).string(), "line", fmt::format("{}", number),
              lines.empty() ? "a file that can be read" : fmt::format("1 to {}", lines.size()));
  }
  const std::string& text = lines[static_cast<std::size_t>(number - 1)];
  const std::size_t first = text.find_first_not_of(" \t", static_cast<std::size_t>(std::max(column, 1) - 1));
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

void number_names(std::vector<Point>& points) {
  std::unordered_map<std::string, int> seen;
  for (Point& point : points) {
    const int number = ++seen[fmt::format("{} {}", kind_name(point.kind), point.name)];
    if (number > 1) point.name += fmt::format(" #{}", number);
  }
}

}  // namespace feline::coverage
