// SPDX-License-Identifier: Apache-2.0
#include "testbench/csv_field.h"

#include <fmt/format.h>

#include <cmath>

namespace feline {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted;
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return fmt::format("\"{}\"", quoted);
}

std::string csv_field(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

}  // namespace feline
