// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/rtl_points.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>

#include "testbench/error.h"
#include "testbench/text_number.h"

namespace feline::coverage {
namespace {

constexpr std::string_view kHead = "# SystemC::Coverage-3";
constexpr std::string_view kUnitScope = "TOP.feline_bench.u_unit";
// The body of a process, or of a loop in it, is entered without a condition. Of combinational processes Verilator moves
// the counter to where the design settles, once.
constexpr std::string_view kUnconditional = "block";

struct Record {
  std::map<std::string, std::string, std::less<>> values;
  std::uint64_t count = 0;

  std::string_view get(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? std::string_view() : std::string_view(found->second);
  }
};

std::optional<Record> parse(std::string_view text) {
  constexpr std::string_view kBegin = "C '";
  const std::size_t end = text.rfind("' ");
  if (!text.starts_with(kBegin) || end == std::string_view::npos || end < kBegin.size()) return std::nullopt;
  Record record;
  const auto count = number_of<std::uint64_t>(text.substr(end + 2));
  if (!count) return std::nullopt;
  record.count = *count;
  std::string_view rest = text.substr(kBegin.size(), end - kBegin.size());
  while (!rest.empty()) {
    const std::size_t value = rest.find('\2');
    if (rest.front() != '\1' || value == std::string_view::npos) return std::nullopt;
    const std::size_t next = std::min(rest.find('\1', value), rest.size());
    record.values.emplace(rest.substr(1, value - 1), rest.substr(value + 1, next - value - 1));
    rest.remove_prefix(next);
  }
  return record;
}

std::optional<Kind> kind_of(std::string_view page) {
  if (page.starts_with("v_line/")) return Kind::kRtlLine;
  if (page.starts_with("v_branch/")) return Kind::kRtlBranch;
  if (page.starts_with("v_toggle/")) return Kind::kRtlToggle;
  return std::nullopt;
}

// Of a point's hierarchy, "u_group.u_products" of "TOP.feline_bench.u_unit.u_group.u_products"; empty for the unit
// itself.
std::optional<std::string> instance_of(std::string_view hierarchy) {
  if (!hierarchy.starts_with(kUnitScope)) return std::nullopt;
  hierarchy.remove_prefix(kUnitScope.size());
  if (hierarchy.empty()) return "";
  if (hierarchy.front() != '.') return std::nullopt;
  return std::string(hierarchy.substr(1));
}

}  // namespace

std::vector<Point> read_rtl_points(const std::filesystem::path& file, SourceText& sources) {
  std::ifstream in(file);
  std::string text;
  int line = 1;
  if (!std::getline(in, text) || text != kHead) bad_input(file.string(), "line 1", text, std::string(kHead));
  const std::filesystem::path root = std::filesystem::absolute(sources.root()).lexically_normal();
  std::vector<Point> points;
  while (std::getline(in, text)) {
    ++line;
    const auto fail = [&](std::string_view field, std::string_view value, std::string_view legal) {
      bad_input(fmt::format("{}:{}", file.string(), line), field, value, legal);
    };
    const auto record = parse(text);
    if (!record) fail("point", text, "C 'keys and values' count");
    const auto kind = kind_of(record->get("page"));
    if (!kind) fail("page", record->get("page"), "v_line/, v_branch/ or v_toggle/");
    const auto instance = instance_of(record->get("h"));
    if (!instance) fail("h", record->get("h"), fmt::format("{} or an instance of it", kUnitScope));
    const auto source_line = number_of<int>(record->get("l"));
    if (!source_line) fail("l", record->get("l"), "a line's number");
    if (record->get("f").empty()) fail("f", "", "a source's name");
    Point point;
    point.kind = *kind;
    const std::filesystem::path source = std::filesystem::absolute(record->get("f")).lexically_normal();
    point.file = source.lexically_relative(root).string();
    point.line = *source_line;
    point.count = record->count;
    const std::string_view what = record->get("o");
    if (*kind == Kind::kRtlLine && what == kUnconditional) continue;
    point.name = *kind == Kind::kRtlToggle
                     ? fmt::format("{}{}{}", *instance, instance->empty() ? "" : ".", what)
                     : fmt::format("{}/{}: {}", *instance, what, sources.line(point.file, point.line));
    points.push_back(std::move(point));
  }
  number_names(points);
  return points;
}

}  // namespace feline::coverage
