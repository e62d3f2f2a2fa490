// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/profile_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "testbench/error.h"
#include "testbench/image.h"
#include "testbench/json_input.h"
#include "testbench/text_number.h"

namespace feline {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kVersion = 1;
// Sums of as many counts as there are stay below 2^64.
constexpr std::uint64_t kMostCount = std::uint64_t{1} << 53;
constexpr std::size_t kHashLength = 40;
constexpr std::string_view kDigits = "0123456789ABCDEF";

// What the values of histograms mean under: a profile of another configuration is another unit's.
std::vector<std::pair<std::string, int>> configuration() {
  std::vector<std::pair<std::string, int>> values;
  for (const ConfigField& each : kConfigFields) values.emplace_back(each.name, kDefaultConfig.*each.field);
  for (const FeatureField& each : kFeatureFields) {
    values.emplace_back(each.name, kDefaultConfig.features.*each.field ? 1 : 0);
  }
  return values;
}

std::string runs_of(const LineSet& lines) {
  std::string text;
  bool read = false;
  for (std::size_t line = 0; line < lines.size(); read = !read) {
    const std::size_t first = line;
    while (line < lines.size() && lines.contains(line) == read) ++line;
    text += fmt::format("{}{}", text.empty() ? "" : " ", line - first);
  }
  return text;
}

Json to_json(const TextureUse& use) {
  Json json{{"names", use.names},
            {"format", kTexelFormatNames[static_cast<std::size_t>(use.format)]},
            {"width", use.width},
            {"height", use.height},
            {"levels", use.levels},
            {"lines", runs_of(use.touched)},
            {"blocks", fmt::format("{}", fmt::join(use.blocks, " "))}};
  return json;
}

// A number as to_chars writes it; nothing else.
std::optional<std::int64_t> whole(std::string_view text) {
  const auto value = number_of<std::int64_t>(text);
  return value && fmt::format("{}", *value) == text ? value : std::nullopt;
}

// A place in the file, which complaints name.
class Node {
 public:
  Node(const Json& json, std::string_view where, std::string field = "")
      : json_(json), where_(where), field_(std::move(field)) {}

  [[noreturn]] void refuse(std::string_view value, std::string_view legal) const {
    bad_input(where_, field_.empty() ? "profile" : field_, value, legal);
  }

  // An object of exactly these fields.
  void check_fields(const std::vector<std::string>& names) const {
    check_object();
    for (const auto& [key, value] : json_.items()) {
      if (std::ranges::find(names, key) == names.end()) {
        below(key, value).refuse("a field", fmt::format("nothing here but {}", fmt::join(names, ", ")));
      }
    }
    for (const std::string& name : names) {
      if (!json_.contains(name)) Node(json_, where_, path(name)).refuse("nothing", "a value");
    }
  }
  Node operator[](const std::string& name) const { return below(name, json_.at(name)); }

  template <typename Use>
  void each(const Use& use) const {
    check_object();
    for (const auto& [key, value] : json_.items()) use(key, below(key, value));
  }

  std::uint64_t number(std::uint64_t least, std::uint64_t most) const {
    const bool legal =
        json_.is_number_unsigned() && json_.get<std::uint64_t>() >= least && json_.get<std::uint64_t>() <= most;
    if (!legal) refuse(shown(), fmt::format("a whole number, {} to {}", least, most));
    return json_.get<std::uint64_t>();
  }
  std::string text() const {
    if (!json_.is_string()) refuse(shown(), "a string");
    return json_.get<std::string>();
  }
  std::vector<Node> items() const {
    if (!json_.is_array()) refuse(shown(), "an array");
    std::vector<Node> all;
    for (std::size_t i = 0; i < json_.size(); ++i) {
      all.emplace_back(json_[i], where_, fmt::format("{}[{}]", field_, i));
    }
    return all;
  }

 private:
  Node below(const std::string& name, const Json& json) const { return {json, where_, path(name)}; }
  std::string path(const std::string& name) const { return field_.empty() ? name : field_ + "." + name; }
  std::string shown() const {
    constexpr std::size_t kEnough = 60;
    const std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() <= kEnough ? text : text.substr(0, kEnough) + " ...";
  }
  void check_object() const {
    if (!json_.is_object()) refuse(shown(), "an object");
  }

  const Json& json_;
  std::string_view where_;
  std::string field_;
};

Histogram read_histogram(const Node& node, const ReachFacts& of) {
  Histogram histogram;
  node.each([&](const std::string& key, const Node& count) {
    std::optional<std::int64_t> value = whole(key);
    if (!of.names.empty()) {
      const auto found = std::ranges::find(of.names, key);
      value.reset();
      if (found != of.names.end()) value = of.least + (found - of.names.begin());
    }
    if (!value || *value < of.least || *value > of.most) {
      node.refuse(key, of.names.empty() ? fmt::format("values of {} to {}", of.least, of.most)
                                        : fmt::format("{}", fmt::join(of.names, ", ")));
    }
    histogram[*value] = count.number(1, kMostCount);
  });
  return histogram;
}

// Whole numbers of 0 to `most` with a space between.
std::vector<std::uint64_t> read_numbers(const Node& node, std::uint64_t most, const std::string& legal) {
  const std::string text = node.text();
  std::vector<std::uint64_t> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string item = text.substr(at, end - at);
    const std::optional<std::int64_t> number = whole(item);
    if (!number || *number < 0 || static_cast<std::uint64_t>(*number) > most) {
      node.refuse(item.empty() ? "an empty number" : item, legal);
    }
    numbers.push_back(static_cast<std::uint64_t>(*number));
    at = end + 1;
  }
  return numbers;
}

LineSet read_lines(const Node& node, std::size_t size) {
  const std::string legal = fmt::format(
      "lengths of runs of lines with a space between, not read and read in turn, only the first one may be 0, {} lines "
      "in all",
      size);
  LineSet lines(size);
  std::size_t line = 0;
  bool read = false;
  for (const std::uint64_t run : read_numbers(node, size, legal)) {
    if (run > size - line || (run == 0 && (read || line != 0))) node.refuse(fmt::format("{}", run), legal);
    for (const std::size_t end = line + run; line < end; ++line) {
      if (read) lines.insert(line);
    }
    read = !read;
  }
  if (line != size) node.refuse(fmt::format("{} lines", line), legal);
  return lines;
}

std::vector<std::uint64_t> read_blocks(const Node& node, std::size_t size) {
  const std::string legal = fmt::format("{} counts of 0 to {} with a space between", size, kMostCount);
  std::vector<std::uint64_t> blocks = read_numbers(node, kMostCount, legal);
  if (blocks.size() != size) node.refuse(fmt::format("{} counts", blocks.size()), legal);
  return blocks;
}

TextureUse read_texture(const Node& node) {
  node.check_fields({"names", "format", "width", "height", "levels", "lines", "blocks"});
  TextureUse use;
  for (const Node& name : node["names"].items()) {
    const std::string text = name.text();
    if (!use.names.empty() && *use.names.rbegin() >= text) name.refuse(text, "names in order, each once");
    use.names.insert(text);
  }
  if (use.names.empty()) node["names"].refuse("[]", "at least one name");
  const std::string format = node["format"].text();
  const auto found = std::ranges::find(kTexelFormatNames, format);
  if (found == kTexelFormatNames.end()) {
    node["format"].refuse(format, fmt::format("one of {}", fmt::join(kTexelFormatNames, ", ")));
  }
  use.format = static_cast<TexelFormat>(found - kTexelFormatNames.begin());
  use.width = static_cast<int>(node["width"].number(1, kMaxImageSize));
  use.height = static_cast<int>(node["height"].number(1, kMaxImageSize));
  const auto chain = std::bit_width(static_cast<unsigned>(std::max(use.width, use.height)));
  use.levels = static_cast<int>(node["levels"].number(1, static_cast<std::uint64_t>(chain)));
  use.touched = read_lines(node["lines"], use.first_line(use.levels));
  use.blocks = read_blocks(node["blocks"], use.block_count());
  return use;
}

void check_total(const Node& node, const ReachFacts& of, std::uint64_t got, const Profile& profile) {
  const std::uint64_t want = of.each == Each::kLookup ? profile.lookups : profile.probes;
  if (of.each == Each::kSome || got == want) return;
  node.refuse(fmt::format("{} in all", got),
              fmt::format("{}, as many as {}", want, of.each == Each::kLookup ? "lookups" : "probes"));
}

}  // namespace

std::string profile_to_json(const Profile& profile) {
  Json json{{"version", kVersion}, {"configuration", Json::object()}, {"sources", Json::object()}};
  for (const auto& [name, value] : configuration()) json["configuration"][name] = value;
  for (const auto& [name, frames] : profile.sources) json["sources"][name] = frames;
  json["lookups"] = profile.lookups;
  json["probes"] = profile.probes;
  for (std::size_t i = 0; i < kReachCount; ++i) {
    const ReachFacts& of = kReachFacts[i];
    Json& histogram = json["reached"][std::string(of.part)][std::string(of.name)] = Json::object();
    for (const auto& [value, count] : profile.reached[i]) histogram[value_name(of, value)] = count;
  }
  json["textures"] = Json::object();
  for (const auto& [hash, use] : profile.textures) json["textures"][hash] = to_json(use);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Profile profile_from_json(std::string_view text, std::string_view where) {
  const Json json = parse_json(text, where, "a file that feline profile wrote");
  const Node root(json, where);
  root.check_fields({"version", "configuration", "sources", "lookups", "probes", "reached", "textures"});
  root["version"].number(kVersion, kVersion);
  std::vector<std::string> names;
  for (const auto& [name, value] : configuration()) names.push_back(name);
  root["configuration"].check_fields(names);
  for (const auto& [name, value] : configuration()) {
    const auto same = static_cast<std::uint64_t>(value);
    root["configuration"][name].number(same, same);
  }
  Profile profile;
  root["sources"].each(
      [&](const std::string& name, const Node& frames) { profile.sources[name] = frames.number(1, kMostCount); });
  profile.lookups = root["lookups"].number(0, kMostCount);
  profile.probes = root["probes"].number(0, kMostCount);
  std::map<std::string, std::vector<std::string>> parts;
  for (const ReachFacts& of : kReachFacts) parts[std::string(of.part)].emplace_back(of.name);
  names.clear();
  for (const auto& [part, fields] : parts) names.push_back(part);
  root["reached"].check_fields(names);
  for (const auto& [part, fields] : parts) root["reached"][part].check_fields(fields);
  for (std::size_t i = 0; i < kReachCount; ++i) {
    const ReachFacts& of = kReachFacts[i];
    const Node node = root["reached"][std::string(of.part)][std::string(of.name)];
    profile.reached[i] = read_histogram(node, of);
    check_total(node, of, total(profile.reached[i]), profile);
  }
  root["textures"].each([&](const std::string& hash, const Node& node) {
    const bool is_hash = hash.size() == kHashLength && hash.find_first_not_of(kDigits) == std::string::npos;
    if (!is_hash) node.refuse(hash, fmt::format("{} hexadecimal digits, in capitals", kHashLength));
    profile.textures[hash] = read_texture(node);
  });
  return profile;
}

Profile read_profile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  // A directory opens, but does not read.
  if (!file || std::filesystem::is_directory(path)) {
    bad_input(path.string(), "open", "no file that can be read", "a file that feline profile wrote");
  }
  const std::string text(std::istreambuf_iterator<char>(file), {});
  return profile_from_json(text, path.string());
}

}  // namespace feline
