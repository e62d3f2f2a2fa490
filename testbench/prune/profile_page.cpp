// SPDX-License-Identifier: Apache-2.0
#include "testbench/prune/profile_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tables/rounding.h"
#include "testbench/image.h"
#include "testbench/page/heat_map.h"
#include "testbench/page/html.h"
#include "testbench/page/plot.h"
#include "testbench/prune/profile_text.h"

namespace feline {
namespace {

// Pictures of more textures than these would be a page that nobody reads.
constexpr std::size_t kMostPictures = 12;

std::string reach_section(const Profile& profile) {
  page::Table table{"", {{"part"}, {"what"}, {"reached"}, {"never"}}, {}};
  for (const ReachWords& words : reach_words(profile)) {
    table.rows.push_back({{std::string(words.of->part)},
                          {std::string(words.of->text)},
                          {words.reached},
                          {words.never, page::Tone::kGood}});
  }
  return page::heading(2, "What is reached, and what never") +
         page::paragraph(
             "Of the lookups, and of their probes from walk to fetch. What is never reached can be left out without a "
             "change to any of these pictures.") +
         page::table(table);
}

struct Bars {
  Reach reach;
  std::string name;  // in the legend
};

// A logarithmic axis shows the one lookup in a million that still needs its part of the unit.
std::string bars(const Profile& profile, const std::string& name, const std::string& title, const std::string& x_label,
                 const std::vector<Bars>& all, page::Style style) {
  page::Plot plot{name, title, {x_label}, {"of all, percent", true}, {}};
  std::int64_t least = INT64_MAX;
  std::int64_t most = INT64_MIN;
  for (const auto& [reach, label] : all) {
    const Histogram& histogram = profile[reach];
    if (histogram.empty()) continue;
    const auto whole = static_cast<double>(is_of_probes(reach) ? profile.probes : profile.lookups);
    page::Series series{label, {}, style};
    const std::int64_t first = histogram.begin()->first;
    const std::int64_t last = histogram.rbegin()->first;
    // A value that is not reached breaks the line.
    for (std::int64_t value = first; value <= last; ++value) {
      const auto count = static_cast<double>(profile.count(reach, value));
      series.points.push_back({static_cast<double>(value), 100 * count / whole});
    }
    plot.series.push_back(std::move(series));
    least = std::min(least, first);
    most = std::max(most, last);
  }
  if (plot.series.empty()) return {};
  plot.x.low = static_cast<double>(least) - 1;
  plot.x.high = static_cast<double>(most) + 1;
  return page::figure(page::svg(plot),
                      fmt::format("{}: {} to {}, of {}.", title, least, most,
                                  is_of_probes(all.front().reach) ? fmt::format("{} probes", profile.probes)
                                                                  : fmt::format("{} lookups", profile.lookups)));
}

std::string plot_section(const Profile& profile) {
  using enum Reach;
  const auto plain = page::Style::kBars;
  const auto lines = page::Style::kLinesPoints;
  std::vector<std::string> plots{
      bars(profile, "probes", "Probes of a lookup", "probes", {{kProbes, ""}}, plain),
      bars(profile, "levels", "Levels that probes read", "level", {{kFineLevel, "finer"}, {kCoarseLevel, "coarser"}},
           lines),
      bars(profile, "exponents", "Exponent of the gradients", "exponent, octaves", {{kExponent, ""}}, plain),
      bars(profile, "position-bits", "Bits of probes' positions, without their sign", "bits",
           {{kProbeBitsS, "s"}, {kProbeBitsT, "t"}}, lines),
      bars(profile, "half-step-bits", "Bits of half steps, without their sign", "bits",
           {{kHalfStepBitsS, "s"}, {kHalfStepBitsT, "t"}}, lines)};
  std::erase(plots, "");
  return page::heading(2, "How often") + page::gallery(plots);
}

std::string cell_map(const Profile& profile) {
  constexpr int kRows = kDefaultConfig.table_rows;
  constexpr int kColumns = kDefaultConfig.table_columns;
  const Histogram& cells = profile[Reach::kCell];
  page::HeatMap map{"Ellipse table cells", "column: angle of the gradients", "row: ratio of their lengths", kColumns,
                    kRows};
  for (int cell = 0; cell < kRows * kColumns; ++cell) map.counts.emplace_back(profile.count(Reach::kCell, cell));
  for (int column = 0; column < kColumns; ++column) map.column_names.push_back(fmt::format("{}", column));
  for (int row = 0; row < kRows; ++row) map.row_names.push_back(fmt::format("{}", row));
  return page::figure(page::svg(map), fmt::format("Lookups in each cell of the ellipse table: {} of {} are reached.",
                                                  cells.size(), kRows * kColumns));
}

// The rows of one probe count beside each other: quarters of fProbes, then the equal weights of mode ext.
std::string weight_map(const Profile& profile) {
  using F = Formats<kDefaultConfig>;
  constexpr int kQuarters = 4;
  page::HeatMap map{"Weight table rows", "fProbes from the count less 3/4, and mode ext", "probes", kQuarters + 1,
                    kDefaultConfig.max_probes};
  map.cell_width = 88;
  map.column_names = {"-3/4", "-1/2", "-1/4", "0", "ext"};
  for (int probes = 1; probes <= kDefaultConfig.max_probes; ++probes) {
    map.row_names.push_back(fmt::format("{}", probes));
    for (int quarter = 0; quarter < kQuarters; ++quarter) {
      const int row = kQuarters * probes - 7 + quarter;
      map.counts.push_back(row < 0 ? std::nullopt : std::optional(profile.count(Reach::kWeightRow, row)));
    }
    map.counts.emplace_back(profile.count(Reach::kWeightRow, F::kGaussianRows + probes - 1));
  }
  return page::figure(page::svg(map), fmt::format("Lookups with each row of the weight table: {} of {} are reached.",
                                                  profile[Reach::kWeightRow].size(), F::kWeightRows));
}

std::string mantissa_map(const Profile& profile) {
  constexpr std::array<Reach, 4> kReaches{Reach::kDudx, Reach::kDvdx, Reach::kDudy, Reach::kDvdy};
  constexpr std::int64_t kMost = Formats<kDefaultConfig>::kMantissa.max_raw();
  page::HeatMap map{"Mantissas", "mantissa", "", static_cast<int>(2 * kMost + 1), static_cast<int>(kReaches.size())};
  map.cell_width = 2;
  map.cell_height = 60;
  for (const Reach reach : kReaches) {
    map.row_names.emplace_back(facts(reach).name);
    for (std::int64_t value = -kMost; value <= kMost; ++value) map.counts.emplace_back(profile.count(reach, value));
  }
  for (std::int64_t value = -kMost; value <= kMost; ++value) {
    map.column_names.push_back(value % 32 == 0 ? fmt::format("{}", value) : "");
  }
  return page::figure(page::svg(map), "Lookups with each value of the four mantissas, texels * 2^exponent.");
}

// Level 0 from above, a pixel a tile or as many as keep the picture below 256 x 256.
std::string memory_map(const TextureUse& use) {
  constexpr int kMostPixelsLog2 = 8;
  const int columns = use.tile_columns(0);
  const int rows = use.tile_rows(0);
  const int shift = std::max(bit_length(std::max(columns, rows) - 1) - kMostPixelsLog2, 0);
  const int width = ((columns - 1) >> shift) + 1;
  const int height = ((rows - 1) >> shift) + 1;
  const std::uint64_t most = std::ranges::max(use.blocks);
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      bool touched = false;
      for (int row = y << shift; row < std::min((y + 1) << shift, rows); ++row) {
        for (int column = x << shift; column < std::min((x + 1) << shift, columns); ++column) {
          touched |= use.touched.contains(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                                          static_cast<std::size_t>(column));
        }
      }
      const int block_row = (y << shift) >> use.block_shift();
      const int block_column = (x << shift) >> use.block_shift();
      const auto block = static_cast<std::size_t>(block_row * use.block_columns() + block_column);
      for (const int channel : page::heat_colour(touched ? use.blocks[block] : 0, most)) {
        pixels.push_back(static_cast<std::uint8_t>(channel));
      }
    }
  }
  const std::string name = fmt::format("{}", fmt::join(use.names, ", "));
  const auto png = encode_png("profile.html", width, height, 3, std::span<const std::uint8_t>(pixels));
  return page::figure(page::png(page::base64(png), name + ", level 0", true),
                      fmt::format("{}, {} x {} texels: {} of level 0", name, use.width, use.height,
                                  percent(use.touched.count(0, use.line_count(0)), use.line_count(0))));
}

std::string memory_section(const Profile& profile) {
  if (profile.textures.empty()) return {};
  page::Table table{"",
                    {{"texture"},
                     {"format"},
                     {"width", true},
                     {"height", true},
                     {"level", true},
                     {"lines", true},
                     {"read", true},
                     {"", true}},
                    {}};
  std::vector<std::pair<std::uint64_t, const TextureUse*>> order;
  for (const auto& [hash, use] : profile.textures) {
    std::uint64_t reads = 0;
    for (const std::uint64_t block : use.blocks) reads = saturating_sum(reads, block);
    order.emplace_back(reads, &use);
    for (int level = 0; level < use.levels; ++level) {
      const std::size_t first = use.first_line(level);
      const std::size_t lines = use.line_count(level);
      const std::size_t read = use.touched.count(first, first + lines);
      table.rows.push_back({{level == 0 ? fmt::format("{}", fmt::join(use.names, ", ")) : ""},
                            {level == 0 ? std::string(kTexelFormatNames[static_cast<std::size_t>(use.format)]) : ""},
                            {fmt::format("{}", std::max(use.width >> level, 1))},
                            {fmt::format("{}", std::max(use.height >> level, 1))},
                            {fmt::format("{}", level)},
                            {fmt::format("{}", lines)},
                            {fmt::format("{}", read)},
                            {percent(read, lines), read == 0 ? page::Tone::kGood : page::Tone::kPlain}});
    }
  }
  std::ranges::stable_sort(order, std::greater{}, [](const auto& item) { return item.first; });
  std::vector<std::string> pictures;
  for (const auto& [reads, use] : order) {
    if (reads != 0 && pictures.size() < kMostPictures) pictures.push_back(memory_map(*use));
  }
  return page::heading(2, "Textures") +
         page::paragraph(fmt::format(
             "Level 0{}, a pixel for each tile of 4 x 4 texels, which is a line of memory, or for several. Slate was "
             "never read; the rest goes from dark red over yellow to white, by the texels read around there, "
             "logarithmically.",
             order.size() > kMostPictures ? fmt::format(" of the {} textures most read", kMostPictures) : "")) +
         page::gallery(pictures) + page::fold("Memory lines read of every level", page::table(table));
}

}  // namespace

std::string profile_page(const Profile& profile) {
  std::string html = page::paragraph(profile_headline(profile)) + reach_section(profile) + plot_section(profile);
  html += page::heading(2, "Tables and numbers");
  html += page::gallery(std::array{cell_map(profile), weight_map(profile), mantissa_map(profile)});
  return page::document("Feline: what a scene reaches", html + memory_section(profile));
}

}  // namespace feline
