// SPDX-License-Identifier: Apache-2.0
#include "testbench/measure/contestant.h"

#include <gtest/gtest.h>

#include <set>

#include "model/unit.h"
#include "testbench/cosim/cosimulation.h"
#include "testbench/measure/errors.h"
#include "tests/testbench/measure/surfaces.h"

namespace feline {
namespace {

constexpr int kContestantSide = 12;

struct Shown {
  explicit Shown(std::string_view scene, const reference::Wrapping& wrapping = {}, int width = kContestantSide,
                 int height = kContestantSide)
      : surface(make_surface(small_scene(scene).texture(), wrapping, MipEdge::kRepeat)),
        view(make_view(small_scene(scene), surface, width, height)) {}
  Surface surface;
  View view;
};

SamplerState<kDefaultConfig> sampler_of(SamplerOptions options, const Surface& surface) {
  const reference::Wrapping& wrapping = surface.images.lanczos.wrapping;
  options.wrap_s = wrapping.s;
  options.wrap_t = wrapping.t;
  for (std::size_t c = 0; c < 4; ++c) options.border[c] = static_cast<double>(wrapping.border[c]);
  return make_sampler<kDefaultConfig>(options, surface.texture, surface.memory);
}

TEST(measure_contestant, each_has_a_name_of_its_own) {
  std::set<std::string> names;
  for (const Contestant& contestant : contestants()) {
    EXPECT_TRUE(names.insert(contestant.name).second) << contestant.name;
    EXPECT_EQ(find_contestant(contestant.name), &contestant);
    EXPECT_FALSE(contestant.description.empty());
    EXPECT_FALSE(contestant.source.empty());
    EXPECT_EQ(contestant.kind == Contestant::Kind::kUnit, contestant.name.starts_with("unit_"));
    EXPECT_EQ(contestant.kind == Contestant::Kind::kUnit, contestant.sampler.has_value());
    EXPECT_EQ(contestant.kind == Contestant::Kind::kLibrary, contestant.name == "openimageio");
    const bool listed = (", " + filter_names() + ", ").find(", " + contestant.name + ", ") != std::string::npos;
    EXPECT_EQ(listed, contestant.kind != Contestant::Kind::kUnit) << contestant.name;
    EXPECT_NE((", " + contestant_names() + ", ").find(", " + contestant.name + ", "), std::string::npos);
  }
  for (const reference::Filter& filter : reference::filters()) EXPECT_TRUE(names.contains(filter.name));
  EXPECT_EQ(names.size(), reference::filters().size() + 16 + 1);
  EXPECT_EQ(find_contestant("best"), nullptr);
}

TEST(measure_contestant, the_unit_is_the_model_lookup_by_lookup) {
  const Shown shown("sphere", {Wrap::kClampToBorder, Wrap::kMirroredRepeat, {0.25F, 0.5F, 0.75F, 1}});
  using F = Formats<kDefaultConfig>;
  for (const Contestant& contestant : contestants()) {
    if (contestant.kind != Contestant::Kind::kUnit) continue;
    SCOPED_TRACE(contestant.name);
    const auto sampler = sampler_of(*contestant.sampler, shown.surface);
    const Rendering rendering = contestant.render(shown.view, nullptr);
    ASSERT_EQ(rendering.picture.pixels.size(), std::size_t{kContestantSide * kContestantSide});
    double probes = 0;
    for (std::size_t i = 0; i < rendering.picture.pixels.size(); ++i) {
      double own = 0;
      const auto pixel = sample<kDefaultConfig>(
          make_request<kDefaultConfig>(shown.view.gbuffer.lookups[i], 0), sampler, shown.surface.memory,
          [&]<typename Beat>(const Beat&) { own += std::is_same_v<Beat, WalkBeat<kDefaultConfig>> ? 1 : 0; });
      for (std::size_t c = 0; c < 4; ++c) {
        const double value = F::kPixel.value(pixel.colour[c].raw()) / 255;
        EXPECT_EQ(rendering.picture.pixels[i][c], static_cast<float>(value));
      }
      EXPECT_EQ(rendering.probes[i], own);
      probes += own;
    }
    EXPECT_EQ(rendering.cost.probes, probes);
    EXPECT_EQ(rendering.cost.cycles, probes);
    EXPECT_GE(rendering.cost.texels, probes);
    EXPECT_LE(rendering.cost.texels, 8 * probes);
    EXPECT_GT(rendering.nanoseconds, 0);
  }
}

TEST(measure_contestant, texels_of_the_plain_modes) {
  const Shown shown("spin");
  const auto texels = [&](const char* name) {
    return find_contestant(name)->render(shown.view, nullptr).cost.texels / (kContestantSide * kContestantSide);
  };
  EXPECT_EQ(texels("unit_nearest"), 1);
  EXPECT_EQ(texels("unit_bilinear"), 4);
  EXPECT_GT(texels("unit_trilinear"), 4);
  EXPECT_LE(texels("unit_trilinear"), 8);
}

TEST(measure_contestant, every_one_has_a_picture_and_its_costs) {
  const Shown shown("tessellated");
  for (const Contestant& contestant : contestants()) {
    SCOPED_TRACE(contestant.name);
    const Rendering rendering = contestant.render(shown.view, nullptr);
    for (const auto& pixel : rendering.picture.pixels) {
      for (const float channel : pixel) {
        EXPECT_GT(channel, -0.2F);
        EXPECT_LT(channel, 1.2F);
      }
      EXPECT_NEAR(pixel[3], 1, 1e-6);
    }
    EXPECT_GT(rendering.nanoseconds, 0);
    const bool told = contestant.kind != Contestant::Kind::kLibrary;
    EXPECT_EQ(rendering.probes.empty(), !told);
    EXPECT_EQ(rendering.cost.probes > 0, told);
    EXPECT_EQ(rendering.cost.texels >= kContestantSide * kContestantSide, told);
    EXPECT_EQ(rendering.cost.cycles >= kContestantSide * kContestantSide, told);
    EXPECT_GE(rendering.cost.stamp_cycles, rendering.cost.cycles);
    double sum = 0;
    for (const float probes : rendering.probes) sum += static_cast<double>(probes);
    EXPECT_NEAR(sum, rendering.cost.probes, 1e-3 * sum);
  }
}

TEST(measure_contestant, openimageio_of_a_constant_is_the_constant) {
  Shown shown("spin");
  MipLevel base = shown.surface.texture.levels[0];
  for (std::size_t i = 0; i < base.texels.size(); ++i) base.texels[i] = i % 4 == 3 ? 255 : 51;
  const Texture texture{TexelFormat::kRgba8, false, build_mip_chain(base, 4, MipFilter::kLanczos, false)};
  const Surface surface = make_surface(texture, {}, MipEdge::kRepeat);
  shown.view.surface = &surface;
  for (const auto& pixel : find_contestant("openimageio")->render(shown.view, nullptr).picture.pixels) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], 0.2, 1e-5);
  }
}

// Its mip levels are the surface's: where a level fits exactly, nothing but one probe of it is there.
TEST(measure_contestant, openimageio_takes_the_surfaces_levels) {
  Shown shown("spin", {}, 16, 16);
  const auto& levels = shown.surface.images.lanczos.levels;
  for (const int level : {0, 1, 3}) {
    const auto step = static_cast<float>(1 << level) / 64;
    for (std::size_t i = 0; i < shown.view.gbuffer.lookups.size(); ++i) {
      const std::size_t rows_above = i / 16;
      const auto column = static_cast<float>(i % 16);
      const auto row = static_cast<float>(rows_above);
      shown.view.gbuffer.lookups[i] = {(column + 0.5F) * step, (row + 0.5F) * step, step, 0, 0, step};
    }
    const FloatPicture picture = find_contestant("openimageio")->render(shown.view, nullptr).picture;
    const reference::Level& own = levels[static_cast<std::size_t>(level)];
    for (int row = 0; row < 16; ++row) {
      for (int column = 0; column < 16; ++column) {
        const auto& texel = own.texels[static_cast<std::size_t>((row % own.height) * own.width + column % own.width)];
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(picture.at(column, row)[c], texel[c], 1e-4) << level;
      }
    }
  }
}

// A filter reads no other pyramid of the surface than it says.
TEST(measure_contestant, pyramids) {
  const Shown whole("sphere");
  Shown own("sphere");
  for (const Contestant& contestant : contestants()) {
    own.surface =
        make_surface(small_scene("sphere").texture(), {}, MipEdge::kRepeat, std::span(&contestant.pyramid, 1));
    own.view.surface = &own.surface;
    const auto picture = contestant.render(own.view, nullptr).picture;
    EXPECT_EQ(picture.pixels, contestant.render(whole.view, nullptr).picture.pixels) << contestant.name;
  }
  EXPECT_TRUE(own.surface.images.box.levels.empty());
  EXPECT_TRUE(own.surface.images.rip.levels.empty());
}

// Mip-mapped EWA against every texel of level 0, on pictures: in codes of 255, 2 on the root mean square and 32 at
// most.
TEST(measure_contestant, mip_mapped_ewa_is_near_every_texel_of_level_0) {
  for (const Scene& scene : scenes()) {
    constexpr std::array kBox{reference::Pyramid::kBox};
    const Surface surface = make_surface(scene.texture(), {}, MipEdge::kRepeat, kBox);
    const View view = make_view(scene, surface, 64, 64);
    const auto picture = [&](const char* name) { return find_contestant(name)->render(view, nullptr).picture; };
    const Errors errors = compare(picture("ewa"), picture("ewa_level0"), bytes_per_texel(surface.texture.format));
    EXPECT_LT(255 * errors.rmse(), 2) << scene.name;
    EXPECT_LT(255 * errors.worst, 32) << scene.name;
    // They are not one and the same: only a magnified texture is read on level 0 by both.
    EXPECT_EQ(errors.worst > 0.001, scene.name != "magnify") << scene.name;
  }
}

TEST(measure_contestant, openimageio_is_near_the_truth) {
  const Surface surface = make_surface(find_scene("checkerboard").texture(), {}, MipEdge::kRepeat);
  const View view = make_view(find_scene("checkerboard"), surface, 32, 32);
  const Truth truth = compute_truth(view, 8, 1, nullptr);
  const auto psnr = [&](const char* name) {
    return compare(find_contestant(name)->render(view, nullptr).picture, truth.gaussian, 3).psnr();
  };
  EXPECT_GT(psnr("openimageio"), 25);
  EXPECT_GT(psnr("openimageio"), psnr("nearest"));
  EXPECT_GT(psnr("ewa"), 35);
}

// Rows 8, 24, 40, 56 and the last one, each after the row before it.
TEST(measure_contestant, rtl_cycles_are_those_of_a_cosimulation) {
  const Shown shown("spin", {}, 8, 70);
  for (const char* const name : {"unit_table_gaussian", "unit_nearest"}) {
    const SamplerOptions options = *find_contestant(name)->sampler;
    const double cycles = measure_rtl_cycles(shown.view, options);
    EXPECT_EQ(cycles, measure_rtl_cycles(shown.view, options));
    EXPECT_GT(cycles, 1);
    std::uint64_t sum = 0;
    for (const std::ptrdiff_t row : {8, 24, 40, 56, 69}) {
      Cosimulation cosimulation(make_fast_unit, Timing{});
      const std::span<const Lookup> lookups(shown.view.gbuffer.lookups.begin() + 8 * (row - 1), 16);
      std::vector<std::uint64_t> at;
      ASSERT_TRUE(cosimulation.run(Batch{sampler_of(options, shown.surface), &shown.surface.memory, lookups, 0},
                                   [&](std::uint64_t, const auto&) { at.push_back(cosimulation.cycles()); }));
      ASSERT_EQ(at.size(), 16U);
      sum += cosimulation.cycles() - at[7];
    }
    EXPECT_DOUBLE_EQ(cycles, static_cast<double>(sum) / 40) << name;
  }
  EXPECT_GT(measure_rtl_cycles(Shown("spin", {}, 8, 2).view, {}), 1);
}

// What the sample stands for: all pixels in order.
TEST(measure_contestant, rtl_cycles_stand_for_the_whole_picture) {
  const Shown shown("bricks", {}, 128, 128);
  for (const char* const name : {"unit_table", "unit_simple_high_efficiency"}) {
    const SamplerOptions options = *find_contestant(name)->sampler;
    Cosimulation cosimulation(make_fast_unit, Timing{});
    ASSERT_TRUE(cosimulation.run(
        Batch{sampler_of(options, shown.surface), &shown.surface.memory, shown.view.gbuffer.lookups, 0}));
    const double whole = static_cast<double>(cosimulation.cycles()) / (128 * 128);
    EXPECT_NEAR(measure_rtl_cycles(shown.view, options) / whole, 1, 0.1) << name;
  }
}

}  // namespace
}  // namespace feline
