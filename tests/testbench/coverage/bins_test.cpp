// SPDX-License-Identifier: Apache-2.0
// Functional bins: of lookups by the model's beats, of handshakes by a unit's cycles.
#include <gtest/gtest.h>

#include <algorithm>

#include "testbench/coverage/lookup_bins.h"
#include "testbench/coverage/stall_bins.h"
#include "tests/testbench/temp_dir.h"

namespace feline::coverage {
namespace {

const BinGrid& grid_of(const std::vector<BinGrid>& grids, std::string_view name) {
  const auto found = std::ranges::find(grids, name, &BinGrid::name);
  if (found == grids.end()) throw std::logic_error("no such grid");
  return *found;
}

// The bins with a count, as "row, column".
std::vector<std::string> hit(const std::vector<BinGrid>& grids, std::string_view name) {
  const BinGrid& grid = grid_of(grids, name);
  std::vector<std::string> names;
  for (const Point& point : bin_points({grid})) {
    if (point.count != 0) names.push_back(point.name.substr(grid.name().size() + 1));
  }
  return names;
}

using Names = std::vector<std::string>;

TEST(bin_grid, counts_only_bins) {
  BinGrid grid("g", "", {"", words({"a", "b"})}, {"", numbers(1, 2)});
  grid.leave_out(1, 0);
  EXPECT_TRUE(grid.count(0, 1));
  EXPECT_FALSE(grid.count(0, 1));
  EXPECT_THROW(grid.count(1, 0), std::logic_error);
  EXPECT_THROW(grid.count(2, 0), std::logic_error);
  EXPECT_THROW(grid.count(0, 2), std::logic_error);
  const auto points = bin_points({grid});
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1].name, "g/a, 2");
  EXPECT_EQ(points[1].count, 2U);

  const TempDir directory;
  write_bytes(directory / "bins", to_json({grid}).dump());
  const auto again = read_bin_grids(directory / "bins");
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(to_json(again), to_json({grid}));
  auto fraction = to_json({grid});
  fraction[0]["counts"][0] = 1e23;
  write_bytes(directory / "bins", fraction.dump());
  EXPECT_NE(input_error([&] { read_bin_grids(directory / "bins"); }).find("whole number"), std::string::npos);
  write_bytes(directory / "bins", "[{}]");
  EXPECT_NE(input_error([&] { read_bin_grids(directory / "bins"); }).find("JSON"), std::string::npos);
}

struct OneTexture {
  Texture texture{
      TexelFormat::kR8, false, {{2, 3, std::vector<std::uint8_t>(6, 7)}, {1, 1, std::vector<std::uint8_t>(1, 7)}}};
  TextureMemory memory = layout_texture(texture);

  SamplerState<kUnit> sampler(Mode mode, Wrap wrap) const {
    SamplerOptions options;
    options.mode = mode;
    options.wrap_s = options.wrap_t = wrap;
    return make_sampler<kUnit>(options, texture, memory);
  }
};

TEST(lookup_bins, of_one_lookup) {
  const OneTexture one;
  LookupBins bins;
  // Two texels along x and half of one along y of 2 x 3, 1.1 textures right and 0.1 above; a denormal and a -0.
  const Lookup lookup{1.1F, -0.1F, 1.0F, 1e-40F, -0.0F, 1.0F / 6};
  const auto sampler = one.sampler(Mode::kTrilinear, Wrap::kClampToBorder);
  EXPECT_TRUE(bins.observe(lookup, sampler, one.memory));
  EXPECT_FALSE(bins.observe(lookup, sampler, one.memory));
  const auto& grids = bins.grids();
  EXPECT_EQ(hit(grids, "mode"), (Names{"trilinear, bilinear, linear"}));
  EXPECT_EQ(hit(grids, "texel"), (Names{"trilinear, r8"}));
  EXPECT_EQ(hit(grids, "size"), (Names{"clamp_to_border s, 2", "clamp_to_border t, odd"}));
  EXPECT_EQ(hit(grids, "place"), (Names{"clamp_to_border s, 1 to 2", "clamp_to_border t, -1 to 0"}));
  EXPECT_EQ(hit(grids, "operand"),
            (Names{"-0, dsdy", "denormal, dtdx", "normal, s", "normal, dsdx", "normal, dtdy", "-normal, t"}));
  EXPECT_EQ(hit(grids, "probes"), (Names{"trilinear, 1"}));
  EXPECT_EQ(hit(grids, "weight_row"), (Names{"1, 0"}));
  EXPECT_EQ(hit(grids, "level_pair"), (Names{"alone, 1"}));
  EXPECT_EQ(hit(grids, "level_choice"), (Names{"trilinear, neither"}));
  EXPECT_EQ(hit(grids, "border"), (Names{"first, fine second"}));
  EXPECT_EQ(hit(grids, "status"), (Names{"trilinear, none"}));
  EXPECT_TRUE(hit(grids, "ellipse_cell").empty());
  EXPECT_TRUE(hit(grids, "transition").empty());
}

TEST(lookup_bins, of_modes_that_follow_each_other) {
  const OneTexture one;
  LookupBins bins;
  const Lookup lookups[] = {{0.5F, 0.5F, 0.5F, 0, 0, 1.0F / 3}};
  const auto run = [&](Mode mode) { bins.observe({one.sampler(mode, Wrap::kRepeat), &one.memory, lookups, 0}); };
  run(Mode::kTable);
  run(Mode::kExt);
  bins.forget_mode();
  run(Mode::kSimple);
  run(Mode::kSimple);
  EXPECT_EQ(hit(bins.grids(), "transition"), (Names{"simple, simple", "table, ext"}));
  EXPECT_EQ(hit(bins.grids(), "ellipse_cell"), (Names{"15, 8"}));
  // ext takes two probes just above one texel, which rounding outward makes of one.
  EXPECT_EQ(hit(bins.grids(), "weight_row"), (Names{"1, 0", "2, ext"}));
}

// Cycles of one boundary: offered and taken.
StallBins after(std::initializer_list<std::pair<bool, bool>> cycles) {
  StallBins bins;
  for (const auto& [offered, taken] : cycles) {
    RtlUnit::Outputs outputs;
    outputs.offered = offered ? 1 : 0;
    outputs.taken = taken ? 1 : 0;
    bins.cycle({}, outputs);
  }
  return bins;
}

TEST(stall_bins, gaps_and_waits) {
  constexpr std::pair kNone{false, false};
  constexpr std::pair kWaits{true, false};
  constexpr std::pair kTaken{true, true};
  EXPECT_TRUE(hit(after({kNone, kWaits, kTaken, kNone}).grids(), "stall").empty())
      << "before the first, gaps are not told";
  EXPECT_EQ(hit(after({kTaken, kTaken}).grids(), "stall"), (Names{"group, gap 0, wait 0"}));
  EXPECT_EQ(hit(after({kTaken, kNone, kWaits, kTaken}).grids(), "stall"), (Names{"group, gap 1, wait 1"}));
  EXPECT_EQ(hit(after({kTaken, kNone, kNone, kTaken}).grids(), "stall"), (Names{"group, gap 2 to 7, wait 0"}));
  EXPECT_EQ(
      hit(after({kTaken, kWaits, kWaits, kWaits, kWaits, kWaits, kWaits, kWaits, kWaits, kTaken}).grids(), "stall"),
      (Names{"group, gap 0, wait 8 or more"}));
}

TEST(stall_bins, ports_and_resets) {
  StallBins bins;
  RtlUnit::Inputs inputs;
  RtlUnit::Outputs outputs;
  inputs.request_valid = outputs.request_ready = true;
  outputs.memory_request_valid = true;
  outputs.offered = 1U << static_cast<unsigned>(Stage::kWalk);
  bins.cycle(inputs, outputs);
  bins.cycle(inputs, outputs);
  EXPECT_EQ(hit(bins.grids(), "stall"), (Names{"request, gap 0, wait 0"}));
  EXPECT_TRUE(hit(bins.grids(), "reset").empty());
  inputs.reset = true;
  bins.cycle(inputs, outputs);
  bins.cycle(inputs, outputs);
  EXPECT_EQ(hit(bins.grids(), "reset"), (Names{"reset, walk", "reset, memory request"}));
  EXPECT_EQ(grid_of(bins.grids(), "reset").count_of(0, static_cast<std::size_t>(Stage::kWalk)), 1U);
}

}  // namespace
}  // namespace feline::coverage
