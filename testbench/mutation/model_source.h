// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace feline::mutation {

// A place in the model's sources where one thing can be done instead of another (model_site.h).
struct ModelSite {
  std::uint32_t number = 0;
  std::string file;  // "model/plan.h"
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  std::string token;  // "+", "return", "127"
  std::string kind;   // its name in model_site.h
  // What is done instead, in words; empty for a number that it has not.
  std::string alternative(std::uint32_t number) const;
  // "+ at model/plan.h:57.20".
  std::string place() const;
};

// The text with a site at every operator, condition, number and value of its functions, appended to `sites`. It goes by
// the look of the text as clang-format leaves it: an operator of two operands has a space on both sides, a bracket of a
// template has not.
std::string instrument_source(std::string_view text, const std::string& file, std::vector<ModelSite>& sites);

}  // namespace feline::mutation
