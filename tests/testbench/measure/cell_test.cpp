// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/cell.h"

#include <gtest/gtest.h>

#include "testbench/image.h"
#include "tests/testbench/measure/surfaces.h"
#include "tests/testbench/temp_dir.h"

namespace feline {
namespace {

constexpr int kCellSide = 24;
constexpr Focus kFocus{{2, 3, 8}, {0, 0, 12}};

struct Measured {
  Exhibit exhibit;
  std::vector<Truth> truths;
};

Measured measured(std::string_view name) {
  Measured made{plan_exhibit(small_scene(name), kCellSide, kCellSide).build(), {}};
  for (const View& view : made.exhibit.frames) made.truths.push_back(compute_truth(view, 3, 1, nullptr));
  return made;
}

TEST(measure_cell, of_a_still) {
  const Measured made = measured("bricks");
  const Contestant& trilinear = *find_contestant("trilinear");
  const Cell cell = measure_cell(trilinear, made.exhibit, made.truths, kFocus);
  const Rendering rendering = trilinear.render(made.exhibit.frames[0], nullptr);
  const Errors want = compare(rendering.picture, made.truths[0].box, 4);
  EXPECT_EQ(cell.exhibit, "bricks");
  EXPECT_EQ(cell.contestant, "trilinear");
  EXPECT_DOUBLE_EQ(cell.box.errors.mean_square, want.mean_square);
  EXPECT_EQ(cell.box.errors.worst, want.worst);
  EXPECT_EQ(cell.box.errors.worst_column, want.worst_column);
  EXPECT_DOUBLE_EQ(cell.gaussian.errors.mean_square,
                   compare(rendering.picture, made.truths[0].gaussian, 4).mean_square);
  EXPECT_FALSE(cell.gaussian.shimmer);
  EXPECT_FALSE(cell.rtl_cycles);
  EXPECT_DOUBLE_EQ(cell.cost.texels, rendering.cost.texels / (kCellSide * kCellSide));
  EXPECT_EQ(cell.cost.probes, 1);
}

// Means over frames; the worst pixel of the worst frame; the change of the error between neighbours.
TEST(measure_cell, of_a_sequence) {
  const Measured made = measured("spin");
  ASSERT_EQ(made.truths.size(), 8U);
  const Contestant& nearest = *find_contestant("nearest");
  const Cell cell = measure_cell(nearest, made.exhibit, made.truths, kFocus);
  double mean_square = 0;
  double worst = 0;
  int worst_frame = 0;
  double shimmer = 0;
  std::vector<FloatPicture> pictures;
  for (std::size_t i = 0; i < 8; ++i) {
    pictures.push_back(nearest.render(made.exhibit.frames[i], nullptr).picture);
    const Errors errors = compare(pictures[i], made.truths[i].gaussian, 4);
    mean_square += errors.mean_square / 8;
    if (errors.worst > worst) worst_frame = static_cast<int>(i);
    worst = std::max(worst, errors.worst);
    if (i == 0) continue;
    shimmer +=
        temporal_mean_square(pictures[i - 1], made.truths[i - 1].gaussian, pictures[i], made.truths[i].gaussian, 4) / 7;
  }
  EXPECT_NEAR(cell.gaussian.errors.mean_square, mean_square, 1e-12);
  EXPECT_EQ(cell.gaussian.errors.worst, worst);
  EXPECT_EQ(cell.gaussian.worst_frame, worst_frame);
  EXPECT_NEAR(cell.gaussian.shimmer.value(), shimmer, 1e-12);
  EXPECT_EQ(cell.cost.texels, 1);
}

TEST(measure_cell, the_unit_tells_its_cycles_and_the_library_no_probes) {
  const Measured made = measured("bricks");
  const Cell unit = measure_cell(*find_contestant("unit_table"), made.exhibit, made.truths, kFocus);
  EXPECT_GT(unit.rtl_cycles.value(), unit.cost.probes);
  EXPECT_FALSE(unit.probes_png.empty());
  const Cell library = measure_cell(*find_contestant("openimageio"), made.exhibit, made.truths, kFocus);
  EXPECT_TRUE(library.probes_png.empty());
  EXPECT_FALSE(library.detail_png.empty());
}

TEST(measure_cell, is_kept_as_json) {
  const Measured made = measured("spin");
  for (const char* const name : {"unit_table", "openimageio"}) {
    const Cell cell = measure_cell(*find_contestant(name), made.exhibit, made.truths, kFocus);
    const auto json = to_json(cell);
    const Cell back = cell_from_json(nlohmann::ordered_json::parse(json.dump()));
    EXPECT_EQ(to_json(back), json);
    EXPECT_EQ(back.box.errors.mean_square, cell.box.errors.mean_square);
    EXPECT_EQ(back.box.errors.worst_row, cell.box.errors.worst_row);
    EXPECT_EQ(back.gaussian.worst_frame, cell.gaussian.worst_frame);
    EXPECT_EQ(back.gaussian.shimmer, cell.gaussian.shimmer);
    EXPECT_EQ(back.rtl_cycles, cell.rtl_cycles);
    EXPECT_EQ(back.cost.stamp_cycles, cell.cost.stamp_cycles);
    EXPECT_EQ(back.difference_png, cell.difference_png);
  }
  Cell still;
  EXPECT_FALSE(cell_from_json(to_json(still)).gaussian.shimmer);
  EXPECT_FALSE(cell_from_json(to_json(still)).rtl_cycles);
}

TEST(measure_exhibit, stills_and_sequences) {
  const ExhibitPlan still = plan_exhibit(find_scene("bricks"), 30, 20);
  EXPECT_EQ(still.width, 30);
  EXPECT_EQ(still.frame_count, 1);
  EXPECT_TRUE(still.perspective);
  const ExhibitPlan sequence = plan_exhibit(small_scene("spin"), 30, 1);
  EXPECT_EQ(sequence.width, 15);
  EXPECT_EQ(sequence.height, 1);
  const Exhibit exhibit = sequence.build();
  ASSERT_EQ(exhibit.frames.size(), 8U);
  EXPECT_EQ(exhibit.frames[7].gbuffer.width, 15);
  EXPECT_EQ(exhibit.frames[7].surface, exhibit.surface.get());
  EXPECT_NE(plan_exhibit(find_scene("bricks"), 20, 30).identity, still.identity);
  EXPECT_NE(plan_exhibit(find_scene("curves"), 30, 20).identity, still.identity);
  EXPECT_EQ(plan_exhibit(small_scene("text"), 8, 8).build().channels(), 1);
}

TEST(measure_exhibit, your_own_files) {
  const TempDir dir;
  write_gbuffer(dir / "a.exr", make_gbuffer(find_scene("bricks"), 6, 4));
  write_gbuffer(dir / "b.exr", make_gbuffer(find_scene("bricks"), 4, 6));
  const MipLevel small = paint_small<4>();
  write_png(dir / "a.png", small.width, small.height, 4, std::span<const std::uint8_t>(small.texels));
  write_png(dir / "b.png", small.height, small.width / 2, 4, std::span(small.texels).first(small.texels.size() / 2));
  ImageOptions srgb;
  srgb.srgb = true;
  const ExhibitPlan plan = plan_exhibit(dir / "a.exr", dir / "a.png", srgb, Wrap::kMirroredRepeat);
  EXPECT_EQ(plan.name, "a");
  EXPECT_EQ(plan.width, 6);
  EXPECT_EQ(plan.height, 4);
  EXPECT_FALSE(plan.perspective);
  const Exhibit exhibit = plan.build();
  EXPECT_TRUE(exhibit.srgb());
  EXPECT_EQ(exhibit.channels(), 4);
  EXPECT_EQ(exhibit.surface->images.lanczos.wrapping.t, Wrap::kMirroredRepeat);
  EXPECT_EQ(exhibit.frames.front().gbuffer.lookups.size(), 24U);
  // Whatever changes the result changes the identity.
  const std::vector<std::string> identities{
      plan.identity, plan_exhibit(dir / "b.exr", dir / "a.png", srgb, Wrap::kMirroredRepeat).identity,
      plan_exhibit(dir / "a.exr", dir / "b.png", srgb, Wrap::kMirroredRepeat).identity,
      plan_exhibit(dir / "a.exr", dir / "a.png", {}, Wrap::kMirroredRepeat).identity,
      plan_exhibit(dir / "a.exr", dir / "a.png", srgb, Wrap::kRepeat).identity};
  for (std::size_t i = 0; i < identities.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(identities[i], identities[j]) << i << " " << j;
  }
  EXPECT_NE(input_error([&] { plan_exhibit(dir / "none.exr", dir / "a.png", {}, Wrap::kRepeat); }).find("none.exr"),
            std::string::npos);
  EXPECT_NE(input_error([&] { plan_exhibit(dir / "a.exr", dir / "none.png", {}, Wrap::kRepeat); }).find("none.png"),
            std::string::npos);
}

}  // namespace
}  // namespace feline
