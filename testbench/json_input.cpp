// SPDX-License-Identifier: Apache-2.0
#include "testbench/json_input.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "testbench/error.h"

namespace feline {

nlohmann::ordered_json parse_json(std::string_view text, std::string_view where, std::string_view legal) {
  using Json = nlohmann::ordered_json;
  std::vector<std::set<std::string>> open;  // the fields of each object that has not ended
  std::optional<std::string> twice;
  const auto watch = [&](int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > kMostNesting) {
      bad_input(where, "nesting", "deeper", fmt::format("at most {} arrays and objects in each other", kMostNesting));
    }
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second) {
      twice = parsed.get<std::string>();
    }
    return true;
  };
  try {
    Json json = Json::parse(text, watch);
    if (twice) bad_input(where, *twice, "two values", "one");
    return json;
  } catch (const Json::exception& error) {
    bad_input(where, "JSON", error.what(), legal);
  }
}

}  // namespace feline
