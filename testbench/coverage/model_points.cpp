// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/model_points.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <regex>

#include "testbench/error.h"
#include "testbench/text_number.h"

namespace feline::coverage {
namespace {

// Counts are abbreviated, "1.25M"; what matters is whether they are 0.
std::optional<std::uint64_t> count_of(std::string text) {
  if (text.empty()) return std::nullopt;
  double scale = 1;
  constexpr std::string_view kScales = "kMGTPE";
  if (const std::size_t at = kScales.find(text.back()); at != std::string_view::npos) {
    scale = std::pow(1000, static_cast<double>(at + 1));
    text.pop_back();
  }
  std::size_t used = 0;
  try {
    const double value = std::stod(text, &used) * scale;
    if (used == text.size() && value >= 0 && value < 0x1p63) return static_cast<std::uint64_t>(std::ceil(value));
  } catch (const std::exception&) {  // no number
  }
  return std::nullopt;
}

struct Sides {
  std::uint64_t taken = 0;
  std::uint64_t not_taken = 0;
};

class Reader {
 public:
  Reader(const std::filesystem::path& file, SourceText& sources)
      : file_(file), sources_(sources), root_(std::filesystem::absolute(sources.root()).lexically_normal()) {}

  std::vector<Point> read() {
    std::ifstream in(file_);
    if (!in) bad_input(file_.string(), "open", "nothing", "what llvm-cov show prints");
    for (std::string text; std::getline(in, text);) {
      ++line_;
      take(text);
    }
    finish_source();
    number_names(points_);
    return std::move(points_);
  }

 private:
  void take(const std::string& text) {
    static const std::regex source_name(R"(^(/.*):$)");
    static const std::regex counted_line(R"(^ *(\d+)\| *([0-9.]*[kMGTPE]?)\|.*$)");
    static const std::regex branch_sides(R"(^ *\|? *Branch \((\d+):(\d+)\): \[(.*)\]$)");
    static const std::regex both_sides(R"(^True: ([0-9.]+[kMGTPE]?), False: ([0-9.]+[kMGTPE]?)$)");
    std::smatch match;
    if (std::regex_match(text, match, source_name)) {
      finish_source();
      source_ = std::filesystem::path(match[1].str()).lexically_normal().lexically_relative(root_).string();
    } else if (std::regex_match(text, match, counted_line)) {
      add_line(number(match[1]), match[2]);
    } else if (std::regex_match(text, match, branch_sides)) {
      const int source_line = number(match[1]);
      const int column = number(match[2]);
      const std::string sides = match[3];
      if (sides == "Folded - Ignored") return;
      if (!std::regex_match(sides, match, both_sides)) fail("branch", sides, "True: COUNT, False: COUNT");
      Sides& sum = branches_[{source_line, column}];
      sum.taken += count(match[1]);
      sum.not_taken += count(match[2]);
    } else if (text.find("Branch (") != std::string::npos) {
      fail("branch", text, "Branch (LINE:COLUMN): [True: COUNT, False: COUNT]");
    }
  }

  void add_line(int number, const std::string& times) {
    if (source_.empty()) fail("line", std::to_string(number), "one after the name of its file");
    if (times.empty()) return;
    const std::string text = sources_.line(source_, number);
    points_.push_back({Kind::kModelLine, fmt::format("{}/{}", source_, text), source_, number, count(times)});
  }

  std::uint64_t count(const std::string& text) const {
    const auto count = count_of(text);
    if (!count) fail("count", text, "a number, with k, M, G, T, P or E behind it");
    return *count;
  }

  int number(const std::string& text) const {
    const auto value = number_of<int>(text);
    if (!value) fail("line or column", text, "a number");
    return *value;
  }

  void finish_source() {
    for (const auto& [place, sides] : branches_) {
      const auto& [number, column] = place;
      const std::string text = sources_.line(source_, number, column);
      points_.push_back({Kind::kModelBranch, fmt::format("{}/true: {}", source_, text), source_, number, sides.taken});
      points_.push_back(
          {Kind::kModelBranch, fmt::format("{}/false: {}", source_, text), source_, number, sides.not_taken});
    }
    branches_.clear();
  }

  [[noreturn]] void fail(std::string_view field, std::string_view value, std::string_view legal) const {
    bad_input(fmt::format("{}:{}", file_.string(), line_), field, value, legal);
  }

  const std::filesystem::path& file_;
  SourceText& sources_;
  std::filesystem::path root_;
  int line_ = 0;
  std::string source_;
  std::map<std::pair<int, int>, Sides> branches_;
  std::vector<Point> points_;
};

}  // namespace

std::vector<Point> read_model_points(const std::filesystem::path& file, SourceText& sources) {
  return Reader(file, sources).read();
}

}  // namespace feline::coverage
