// SPDX-License-Identifier: Apache-2.0
#include "model/reference/filters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "model/reference/approximate_axes.h"
#include "model/reference/ewa.h"
#include "model/reference/ext.h"
#include "model/reference/feline.h"
#include "model/reference/isotropic.h"
#include "model/reference/texram.h"
#include "tests/support/measured.h"
#include "tests/support/random.h"
#include "tests/support/reference_ewa.h"
#include "tests/support/reference_scene.h"

namespace feline::reference {
namespace {

bool is_gaussian(const Filter& filter) { return filter.name.ends_with("_gaussian"); }
// Reads every texel of an ellipse or circle.
bool is_ewa(const Filter& filter) { return filter.name.starts_with("ewa") || filter.name.ends_with("_circles"); }

TEST(reference_filters, have_names) {
  std::set<std::string> names;
  for (const Filter& filter : filters()) {
    EXPECT_TRUE(names.insert(filter.name).second) << filter.name;
    EXPECT_EQ(find_filter(filter.name), &filter);
    EXPECT_FALSE(filter.description.empty());
    EXPECT_FALSE(filter.source.empty());
    EXPECT_EQ(filter.axis_system.has_value(), filter.name.starts_with("vertex_"));
  }
  EXPECT_EQ(find_filter("none"), nullptr);
  EXPECT_EQ(find_filter(""), nullptr);
}

// Section 4: mip-maps by a Lanczos filter, for EWA by a box filter.
TEST(reference_filters, read_their_images) {
  const auto of = [](double value) {
    return map_of(32, 32, kRepeated, [=](double, double, int) { return grey(value); });
  };
  const Images images{of(0.25), of(0.5),
                      rip_of(32, 32, kRepeated, [](double, double, int, int) { return grey(0.75); })};
  for (const Filter& filter : filters()) {
    Cost cost;
    const auto got = filtered(filter, images, lookup_at(images.box.base(), 9, 9, {{4, 1}, {0, 2}}), cost);
    EXPECT_NEAR(got[0],
                filter.name.starts_with("ewa")   ? 0.5
                : filter.name.starts_with("rip") ? 0.75
                                                 : 0.25,
                1e-15)
        << filter.name;
  }
}

// The rest by their names, of at most 16 probes.
TEST(reference_filters, other_variants) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_filters.other_variants");
  const auto noise = box_map(noise_level(64, 64, random), kRepeated);
  const Images images{noise, noise, {}};
  using Run = std::function<Colour(const Lookup&, Cost&)>;
  const std::map<std::string, Run> runs{
      {"catmull_rom", [&](auto& l, Cost& c) { return bicubic_filter(noise, kCatmullRom, l, c); }},
      {"mitchell", [&](auto& l, Cost& c) { return bicubic_filter(noise, kMitchell, l, c); }},
      {"nearest", [&](auto& l, Cost& c) { return nearest_filter(noise, l, c); }},
      {"nearest_mip", [&](auto& l, Cost& c) { return nearest_mip_filter(noise, l, c); }},
      {"bilinear", [&](auto& l, Cost& c) { return bilinear_filter(noise, l, c); }},
      {"bilinear_mip", [&](auto& l, Cost& c) { return bilinear_mip_filter(noise, l, c); }},
      {"trilinear", [&](auto& l, Cost& c) { return trilinear_filter(noise, l, c); }},
      {"ext", [&](auto& l, Cost& c) { return ext_filter(noise, 16, l, c); }},
      {"texram", [&](auto& l, Cost& c) { return texram_filter(noise, 16, l, c); }},
      {"ewa",
       [&](auto& l, Cost& c) {
         return ewa_filter(noise, {true, 16}, l, c);
       }},
      {"ewa_level0", [&](auto& l, Cost& c) {
         return ewa_filter(noise, {false, 0}, l, c);
       }}};
  for (const auto& [name, run] : runs) {
    const Filter* filter = find_filter(name);
    ASSERT_NE(filter, nullptr) << name;
    for (int i = 0; i < 50; ++i) {
      const auto g = random_gradients(random, random.real(4, 60), random.real(0, 4));
      const auto lookup = lookup_at(noise.base(), random.real(0, 64), random.real(0, 64), g);
      Cost got_cost;
      Cost want_cost;
      EXPECT_EQ(filtered(*filter, images, lookup, got_cost), run(lookup, want_cost)) << name;
      EXPECT_EQ(got_cost.cycles, want_cost.cycles) << name;
    }
  }
}

// Every Feline there is: three ways to the ellipse, three sets of factors (3.1 and 3.4), two kernels.
TEST(reference_filters, feline_variants) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_filters.feline_variants");
  const auto noise = box_map(noise_level(128, 128, random), kRepeated);
  const Images images{noise, noise, {}};
  const std::map<std::string, AxesFunction> kinds{
      {"ideal", ellipse_axes<double>}, {"simple", simple_axes}, {"table", table_axes}};
  const std::map<std::string, FelineParameters> sets{{"", {}},
                                                     {"_high_quality", {true, 0.9625, 1.15625, 1.1532, 16}},
                                                     {"_high_efficiency", {true, 0.9625, 1.3125, 1.3544, 16}}};
  const std::map<std::string, ProbeKernel> kernels{{"", ProbeKernel::kBilinear}, {"_gaussian", ProbeKernel::kGaussian}};
  for (const auto& [kind, axes] : kinds) {
    for (const auto& [set, parameters] : sets) {
      for (const auto& [kernel_name, kernel] : kernels) {
        std::string name = "feline_" + kind;
        name.append(set).append(kernel_name);
        const Filter* filter = find_filter(name);
        ASSERT_NE(filter, nullptr) << name;
        for (int i = 0; i < 50; ++i) {
          const auto g = random_gradients(random, random.real(4, 60), random.real(0, 4));
          const auto lookup = lookup_at(noise.base(), random.real(0, 128), random.real(0, 128), g);
          Cost got_cost;
          Cost want_cost;
          const auto got = filtered(*filter, images, lookup, got_cost);
          EXPECT_EQ(got, feline_filter(noise, axes, parameters, kernel, lookup, want_cost)) << filter->name;
          EXPECT_EQ(got_cost.probes, want_cost.probes);
        }
      }
    }
  }
}

// Footprints of every size, shape and place, and of none; `most` is the power of ten of the greatest.
Gradients<double> any_gradients(Random& random, double most) {
  const auto size = [&] {
    if (random.one_in(8)) return 0.0;
    return random.one_in(4) ? log_uniform(random, -320, most) : log_uniform(random, -12, std::min(12.0, most));
  };
  switch (random.below(5)) {
    case 0: return random_gradients(random, size(), size());
    case 1: return random_gradients(random, random.real(1, 30), random.real(0, 4));
    case 2: return {{size(), 0}, {0, size()}};
    case 3: return {{size(), size()}, {0, 0}};
    default: {
      const Vector2<double> line{size(), -size()};
      return {line, random.real(-1, 1) * line};
    }
  }
}

// Weights sum to 1, whatever the footprint is and however the texture ends.
TEST(reference_filters, constants_stay) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_filters.constants_stay");
  constexpr Texel kConstant{0.1F, 0.5F, 0.9F, 1};
  constexpr Colour kWant{0.1F, 0.5F, 0.9F, 1};
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClampToEdge, Wrap::kClampToBorder}) {
    const Wrapping wrapping{wrap, wrap, kConstant};
    const auto mip = map_of(64, 32, wrapping, [&](double, double, int) { return kConstant; });
    const auto rip = rip_of(64, 32, wrapping, [&](double, double, int, int) { return kConstant; });
    const Images images{mip, mip, rip};
    for (const Filter& filter : filters()) {
      for (int i = 0; i < 200; ++i) {
        const double far = random.one_in(3) ? 1e6 : 100;
        const auto lookup =
            lookup_at(mip.base(), random.real(-far, far), random.real(-far, far),
                      any_gradients(random, filter.name == "ewa_level0" && !random.one_in(8) ? 1.6 : 300));
        Pixel pixel = pixel_of(filter, lookup, mip.base());
        pixel.polygon_middle = lookup_at(mip.base(), 0, 0, any_gradients(random, 300));
        Cost cost;
        const auto got = filter.run(images, pixel, cost);
        ASSERT_LE(distance(got, kWant), 1e-12) << filter.name;
        ASSERT_GE(cost.probes, 1) << filter.name;
        ASSERT_GE(cost.texels, 1) << filter.name;
        ASSERT_GE(cost.cycles, 1) << filter.name;
        ASSERT_GE(cost.stamp_cycles, cost.cycles) << filter.name;
      }
    }
  }
}

// What a ramp becomes is the filter's first moment: symmetric filters have none, but for texels' grid. Linear
// interpolation, cubics with B + 2C = 1 and any symmetric sum of them return the lookup's own position; the nearest
// texel is half a texel off; the Gaussian probe's 1/(1 + e^(1 - 2f)) is not f, by 1/(1 + e) of a texel at a texel's
// middle, and of two levels at most (1 + f)/2^f = 1.062 times as much; EWA gains
// or loses texels of weight e^-2 on the rim, of 4 % of the sum and 1.5 texels away where the minor radius is 1.5.
TEST(reference_filters, ramps_stay) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_filters.ramps_stay");
  const auto ramp = ramp_map(256, 128);
  const Images images{
      ramp, ramp, rip_of(256, 128, kClamped, [](double s, double t, int, int) { return ramp_texel(s, t, 256, 128); })};
  const auto number = level_map(256, 128);
  const Images levels{number, number, rip_of(256, 128, kClamped, [](double, double, int, int) { return grey(0); })};
  std::map<std::string, double> worst;
  for (const Filter& filter : filters()) {
    for (int i = 0; i < 300; ++i) {
      const double minor = random.real(0.5, 4);
      const auto g = random_gradients(random, std::min(14.0, minor * random.real(1, 8)), minor);
      const double u = random.real(108, 148);
      const double v = random.real(54, 74);
      const auto lookup = lookup_at(ramp.base(), u, v, g);
      Cost cost;
      const auto got = filtered(filter, images, lookup, cost);
      const double texel = std::exp2(filtered(filter, levels, lookup, cost)[0]);  // of the level of detail
      const double error = std::max(std::abs(1024 * got[0] - u), std::abs(1024 * got[1] - v)) / texel;
      worst[filter.name] = std::max(worst[filter.name], error);
    }
    const double most = filter.name.starts_with("nearest") ? 0.5
                        : is_gaussian(filter)              ? 1.062 / (1 + std::exp(1))
                        : is_ewa(filter)                   ? 0.3
                                                           : 0;
    EXPECT_LE(worst[filter.name], most + 1e-11) << filter.name;
    if (most > 0) measured(filter.name, worst[filter.name]);
  }
}

}  // namespace
}  // namespace feline::reference
