// SPDX-License-Identifier: Apache-2.0
#include "testbench/coverage/coverage_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "testbench/page/heat_map.h"
#include "testbench/page/html.h"

namespace feline::coverage {
namespace {

// A list of more is one that nobody reads; coverage.json has all.
constexpr std::size_t kMostMissing = 400;

constexpr std::array<std::string_view, kKindCount> kKindTexts{"RTL: blocks of statements under a condition",
                                                              "RTL: branches of if",
                                                              "RTL: bits of every signal",
                                                              "model: lines",
                                                              "model: sides of branches",
                                                              "functional bins"};

using KindFigures = std::map<std::string, Figures>;

// By file, of the points of some kinds.
KindFigures by_file(const std::vector<Point>& points, Kind first, Kind last) {
  std::map<std::string, std::vector<Point>> parts;
  for (const Point& point : points) {
    if (point.kind >= first && point.kind <= last) parts[point.file].push_back(point);
  }
  KindFigures figures;
  for (const auto& [file, part] : parts) figures[file] = figures_of(part);
  return figures;
}

page::Cell figure_cell(const Figure& figure) {
  if (figure.total == 0) return {};
  return {fmt::format("{}/{}", figure.hit, figure.total),
          figure.hit == figure.total ? page::Tone::kGood : page::Tone::kBad};
}

std::string kinds_section(const Figures& figures) {
  page::Table table{"", {{""}, {"reached", true}, {"of", true}, {"", true}, {"excluded", true}}, {}};
  for (std::size_t kind = 0; kind < kKindCount; ++kind) {
    const Figure& figure = figures[kind];
    table.rows.push_back({{std::string(kKindTexts[kind])},
                          {fmt::format("{}", figure.hit)},
                          {fmt::format("{}", figure.total)},
                          {share_text(figure), figure.hit == figure.total ? page::Tone::kGood : page::Tone::kBad},
                          {fmt::format("{}", figure.excluded)}});
  }
  return page::table(table);
}

std::string files_section(const std::vector<Point>& points, std::string_view title, Kind first, Kind last,
                          std::initializer_list<std::string_view> names) {
  page::Table table{"", {{"file"}}, {}};
  for (const std::string_view name : names) table.columns.push_back({std::string(name), true});
  table.columns.push_back({"excluded", true});
  for (const auto& [file, figures] : by_file(points, first, last)) {
    std::vector<page::Cell> row{{file}};
    std::uint64_t excluded = 0;
    for (auto kind = static_cast<std::size_t>(first); kind <= static_cast<std::size_t>(last); ++kind) {
      row.push_back(figure_cell(figures[kind]));
      excluded += figures[kind].excluded;
    }
    row.push_back({excluded == 0 ? "" : fmt::format("{}", excluded)});
    table.rows.push_back(std::move(row));
  }
  return page::heading(2, title) + page::table(table);
}

std::string missing_section(const std::vector<Point>& points, SourceText& sources) {
  page::Table table{"", {{"kind"}, {"name"}, {"place"}, {"source"}}, {}};
  std::size_t missing = 0;
  for (const Point& point : points) {
    if (point.count != 0 || !point.excluded.empty() || missing++ >= kMostMissing) continue;
    table.rows.push_back({{std::string(kind_name(point.kind))},
                          {point.name, page::Tone::kBad},
                          {point.line == 0 ? "" : fmt::format("{}:{}", point.file, point.line)},
                          {point.line == 0 ? "" : sources.line(point.file, point.line)}});
  }
  const std::string heading = page::heading(2, "Not reached");
  if (missing == 0) return heading + page::paragraph("Nothing that is not excluded.");
  return heading +
         (missing > kMostMissing ? page::paragraph(fmt::format("The first {} of {}.", kMostMissing, missing)) : "") +
         page::table(table);
}

std::size_t longest(const std::vector<std::string>& names) {
  std::size_t most = 0;
  for (const std::string& name : names) most = std::max(most, name.size());
  return most;
}

// A bin that is excluded looks like none.
std::string grid_figure(const BinGrid& grid, const std::set<std::string>& excluded) {
  constexpr int kCharacter = 8;  // the mean width of one, rounded up
  page::HeatMap map{grid.text(),
                    grid.columns().text,
                    grid.rows().text,
                    static_cast<int>(grid.columns().names.size()),
                    static_cast<int>(grid.rows().names.size()),
                    {},
                    grid.columns().names,
                    grid.rows().names};
  std::size_t hit = 0;
  std::size_t total = 0;
  for (std::size_t row = 0; row < grid.rows().names.size(); ++row) {
    for (std::size_t column = 0; column < grid.columns().names.size(); ++column) {
      auto count = grid.count_of(row, column);
      if (excluded.contains(grid.bin_name(row, column))) count.reset();
      total += count ? 1 : 0;
      hit += count && *count != 0 ? 1 : 0;
      map.counts.push_back(count);
    }
  }
  // No map is so narrow that the page would blow up its text.
  constexpr int kLeastWidth = 420;
  map.names_width = 36 + kCharacter * static_cast<int>(longest(map.row_names));
  map.cell_width = std::max(map.cell_width, kLeastWidth / map.columns);
  const int names = kCharacter * static_cast<int>(longest(map.column_names));
  if (names > map.cell_width) map.names_height = 12 + names;
  return page::figure(page::svg(map), fmt::format("{} {} of {} reached.", grid.text(), hit, total));
}

std::string bins_section(const Coverage& coverage) {
  std::set<std::string> excluded;
  for (const Point& point : coverage.points) {
    if (point.kind == Kind::kBin && !point.excluded.empty()) excluded.insert(point.name);
  }
  std::vector<std::string> figures;
  for (const BinGrid& grid : coverage.grids) figures.push_back(grid_figure(grid, excluded));
  return page::heading(2, "Functional bins") +
         page::paragraph(
             "How often the suite was there, of lookups and cycles whose every beat was compared with the "
             "model. A crossed cell was never reached; where there is none, nothing can be.") +
         page::gallery(figures);
}

std::string exclusions_section(const Coverage& coverage) {
  page::Table table{"", {{"kind"}, {"names"}, {"points", true}, {"why nothing reaches them"}}, {}};
  for (const Exclusion& exclusion : coverage.exclusions) {
    const auto count = std::ranges::count_if(coverage.points, [&](const Point& point) {
      return point.kind == exclusion.kind && !point.excluded.empty() && matches(exclusion.pattern, point.name);
    });
    table.rows.push_back({{std::string(kind_name(exclusion.kind))},
                          {exclusion.pattern},
                          {fmt::format("{}", count)},
                          {exclusion.reason}});
  }
  return page::heading(2, "Excluded, and why") + page::table(table);
}

}  // namespace

std::string coverage_text(const Coverage& coverage) {
  const Figures figures = figures_of(coverage.points);
  std::string text = fmt::format("{:<46}{:>8}{:>8}{:>9}{:>10}\n", "", "reached", "of", "", "excluded");
  for (std::size_t kind = 0; kind < kKindCount; ++kind) {
    const Figure& figure = figures[kind];
    text += fmt::format("{:<46}{:>8}{:>8}{:>9}{:>10}\n", kKindTexts[kind], figure.hit, figure.total, share_text(figure),
                        figure.excluded);
  }
  return text;
}

nlohmann::ordered_json coverage_json(const Coverage& coverage) {
  nlohmann::ordered_json json = to_json(ratchet_of(coverage.points));
  auto& excluded = json["exclusions"] = nlohmann::ordered_json::array();
  for (const Exclusion& exclusion : coverage.exclusions) {
    excluded.push_back(
        {{"kind", kind_name(exclusion.kind)}, {"pattern", exclusion.pattern}, {"reason", exclusion.reason}});
  }
  for (const auto& [name, first, last] : {std::tuple{"rtl_files", Kind::kRtlLine, Kind::kRtlToggle},
                                          std::tuple{"model_files", Kind::kModelLine, Kind::kModelBranch}}) {
    for (const auto& [file, figures] : by_file(coverage.points, first, last)) {
      for (auto kind = static_cast<std::size_t>(first); kind <= static_cast<std::size_t>(last); ++kind) {
        json[name][file][std::string(kKindNames[kind])] = {{"hit", figures[kind].hit}, {"total", figures[kind].total}};
      }
    }
  }
  json["bins"] = to_json(coverage.grids);
  json["faults"] = coverage.faults;
  return json;
}

std::string coverage_page(const Coverage& coverage, SourceText& sources) {
  const std::vector<Point>& points = coverage.points;
  std::string html = page::paragraph(
      "What the stimuli of the tests reach, in the SystemVerilog unit by Verilator's counters, each instance of a "
      "module on its own, and in the C++ model by LLVM's. Bits of the RTL are counted once its registers hold what "
      "came through the unit; the words of the cache's memory are not. A block counts where it is evaluated, whoever "
      "needs the result: the functional bins are of lookups and cycles, and all that a run makes is compared with the "
      "model, beat by beat.");
  html += kinds_section(figures_of(points));
  if (!coverage.faults.empty()) html += page::heading(2, "What fails") + page::bullets(coverage.faults);
  html += missing_section(points, sources);
  html += bins_section(coverage);
  html += files_section(points, "The RTL, module by module", Kind::kRtlLine, Kind::kRtlToggle,
                        {"blocks", "branches", "bits"});
  html += files_section(points, "The model, file by file", Kind::kModelLine, Kind::kModelBranch, {"lines", "branches"});
  return page::document("Feline: what the tests reach", html + exclusions_section(coverage));
}

}  // namespace feline::coverage
