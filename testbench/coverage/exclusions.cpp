// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/exclusions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "testbench/error.h"
#include "testbench/text_number.h"

namespace feline::coverage {
namespace {

// "7..9"
std::optional<std::pair<int, int>> range_of(std::string_view item) {
  const std::size_t dots = item.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const auto first = number_of<int>(item.substr(0, dots));
  const auto last = number_of<int>(item.substr(dots + 2));
  if (!first || !last) return std::nullopt;
  return std::pair{*first, *last};
}

// Of each place in a name whether what a pattern has so far can end there.
using Places = std::vector<bool>;

// The places behind whole numbers of a range that begin at `from`.
Places after_numbers(std::pair<int, int> range, std::string_view name, const Places& from) {
  Places after(from.size());
  for (std::size_t place = 0; place < from.size(); ++place) {
    if (!from[place]) continue;
    const std::string_view rest = name.substr(place);
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    const auto number = number_of<int>(rest.substr(0, digits));
    if (number && *number >= range.first && *number <= range.second) after[place + digits] = true;
  }
  return after;
}

Places after(std::string_view pattern, std::string_view name, Places from);

// The places behind any of the items "a,b*,7..9" that begins at `from`.
Places after_one_of(std::string_view items, std::string_view name, const Places& from) {
  Places all(from.size());
  while (true) {
    const std::size_t comma = std::min(items.find(','), items.size());
    const std::string_view item = items.substr(0, comma);
    const auto range = range_of(item);
    const Places one = range ? after_numbers(*range, name, from) : after(item, name, from);
    for (std::size_t place = 0; place < all.size(); ++place) all[place] = all[place] || one[place];
    if (comma == items.size()) return all;
    items.remove_prefix(comma + 1);
  }
}

// All places at once, as trying one after the other can take for ever.
Places after(std::string_view pattern, std::string_view name, Places from) {
  while (!pattern.empty()) {
    const std::size_t end = pattern.front() == '{' ? pattern.find('}') : std::string_view::npos;
    if (pattern.front() == '*') {
      std::fill(std::ranges::find(from, true), from.end(), true);
    } else if (end != std::string_view::npos) {
      from = after_one_of(pattern.substr(1, end - 1), name, from);
      pattern.remove_prefix(end);
    } else {
      for (std::size_t place = name.size(); place > 0; --place) {
        from[place] = from[place - 1] && name[place - 1] == pattern.front();
      }
      from[0] = false;
    }
    pattern.remove_prefix(1);
  }
  return from;
}

bool is_kind(std::string_view name) { return std::ranges::find(kKindNames, name) != kKindNames.end(); }

}  // namespace

bool matches(std::string_view pattern, std::string_view name) {
  Places start(name.size() + 1);
  start[0] = true;
  return after(pattern, name, std::move(start)).back();
}

std::vector<Exclusion> read_exclusions(const std::filesystem::path& file) {
  constexpr std::string_view kBeforeReason = " -- ";
  std::ifstream in(file);
  if (!in) bad_input(file.string(), "open", "nothing", "a file of exclusions");
  std::vector<Exclusion> exclusions;
  int line = 0;
  for (std::string text; std::getline(in, text);) {
    ++line;
    if (text.empty() || text.front() == '#') continue;
    const std::size_t space = text.find(' ');
    const std::size_t reason = text.rfind(kBeforeReason);
    const std::string kind = text.substr(0, space);
    const std::string where = fmt::format("{}:{}", file.string(), line);
    if (!is_kind(kind)) bad_input(where, "kind", kind, fmt::format("{}", fmt::join(kKindNames, ", ")));
    if (reason == std::string::npos || reason <= space || reason + kBeforeReason.size() == text.size()) {
      bad_input(where, "exclusion", text, "KIND PATTERN -- REASON");
    }
    exclusions.push_back({static_cast<Kind>(std::ranges::find(kKindNames, kind) - kKindNames.begin()),
                          text.substr(space + 1, reason - space - 1), text.substr(reason + kBeforeReason.size()),
                          line});
  }
  return exclusions;
}

std::vector<std::string> exclude(std::vector<Point>& points, const std::vector<Exclusion>& exclusions) {
  std::vector<std::string> faults;
  for (const Exclusion& exclusion : exclusions) {
    std::size_t named = 0;
    for (Point& point : points) {
      if (point.kind != exclusion.kind || !matches(exclusion.pattern, point.name)) continue;
      ++named;
      if (point.count == 0) {
        point.excluded = exclusion.reason;
      } else {
        faults.push_back(fmt::format("exclusion in line {}, {} {}: {} was reached, {} times", exclusion.line,
                                     kind_name(exclusion.kind), exclusion.pattern, point.name, point.count));
      }
    }
    if (named == 0) {
      faults.push_back(fmt::format("exclusion in line {}, {} {}: names no point", exclusion.line,
                                   kind_name(exclusion.kind), exclusion.pattern));
    }
  }
  return faults;
}

}  // namespace feline::coverage
