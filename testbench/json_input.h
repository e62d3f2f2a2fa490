// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace feline {

// The deepest nesting of any file of this project is 5; copying, comparing and printing JSON take a call a level.
inline constexpr int kMostNesting = 32;

// JSON as a user hands it over. `where` and `legal` are named in messages. Throws InputError for: JSON, text that is
// none; nesting, deeper than kMostNesting; and a field that an object has twice, of which the parser would keep one.
nlohmann::ordered_json parse_json(std::string_view text, std::string_view where, std::string_view legal);

// A whole number that Number holds. Throws std::runtime_error for anything else: get<Number>() would cut it.
template <std::integral Number, typename Json>
Number whole_from_json(const Json& json) {
  using Limits = std::numeric_limits<Number>;
  if (json.is_number_unsigned() && std::in_range<Number>(json.template get<std::uint64_t>()))
    return json.template get<Number>();
  if (json.is_number_integer() && !json.is_number_unsigned() &&
      std::in_range<Number>(json.template get<std::int64_t>())) {
    return json.template get<Number>();
  }
  throw std::runtime_error("not a whole number of " + std::to_string(Limits::min()) + " to " +
                           std::to_string(Limits::max()));
}

}  // namespace feline
