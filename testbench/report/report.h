// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "testbench/measure/survey.h"

namespace feline {

// A survey told in every form.
struct Report {      // NOLINT(bugprone-exception-escape): moving JSON, which asserts
  std::string html;  // one self-contained page
  nlohmann::ordered_json json;
  std::string csv;
  std::string text;   // for a terminal
  bool holds = true;  // every bound that the page states
};
Report make_report(const Survey& survey);

}  // namespace feline
