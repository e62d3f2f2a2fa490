// SPDX-License-Identifier: Apache-2.0
#include "model/reference/filters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "tests/support/measured.h"
#include "tests/support/random.h"
#include "tests/support/reference_ewa.h"
#include "tests/support/reference_scene.h"

namespace feline::reference {
namespace {

bool is_gaussian(const Filter& filter) { return filter.name.ends_with("_gaussian"); }
bool is_ewa(const Filter& filter) { return filter.name.starts_with("ewa"); }

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
        const double most = filter.name == "ewa_level0" ? 1.6 : 300;
        const double far = random.one_in(3) ? 1e6 : 100;
        const auto lookup =
            lookup_at(mip.base(), random.real(-far, far), random.real(-far, far), any_gradients(random, most));
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
