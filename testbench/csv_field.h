// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace feline {

// Fields of RFC 4180: text in quotes where it needs them; a number in full, or nothing where it is not finite.
std::string csv_field(const std::string& text);
std::string csv_field(double value);

}  // namespace feline
