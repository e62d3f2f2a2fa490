// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace feline {

// The first fault of a page that should be whole and need no network, or "": a tag without its end, an end without its
// tag, an id that is there twice, a reference to the network.
inline std::string html_fault(const std::string& html) {
  for (const char* const outside : {"http:", "https:", "src=\"/", "@import", "<link", "<script"}) {
    if (html.find(outside) != std::string::npos) return std::string("refers to the outside: ") + outside;
  }
  constexpr std::array<std::string_view, 5> kVoid{"meta", "img", "br", "hr", "!DOCTYPE"};
  std::vector<std::string> open;
  std::vector<std::string> ids;
  for (std::size_t at = 0; (at = html.find('<', at)) != std::string::npos;) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return "a tag does not end: " + html.substr(at, 40);
    const std::string tag = html.substr(at + 1, end - at - 1);
    at = end + 1;
    const bool closes = tag.starts_with('/');
    const std::size_t first = closes ? 1 : 0;
    std::size_t last = first;
    while (last < tag.size() && std::isspace(static_cast<unsigned char>(tag[last])) == 0 && tag[last] != '/') ++last;
    const std::string name = tag.substr(first, last - first);
    for (const char quote : {'"', '\''}) {
      const std::size_t id = tag.find(std::string(" id=") + quote);
      if (id == std::string::npos) continue;
      const std::string value = tag.substr(id + 5, tag.find(quote, id + 5) - id - 5);
      if (std::ranges::find(ids, value) != ids.end()) return "id twice: " + value;
      ids.push_back(value);
    }
    if (closes) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> within " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (!tag.ends_with('/') && std::ranges::find(kVoid, std::string_view(name)) == kVoid.end()) {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

}  // namespace feline
