// SPDX-License-Identifier: Apache-2.0
// group of units that lack derivatives or exponents.
#include <gtest/gtest.h>

#include <cmath>

#include "model/group.h"
#include "tests/support/describe.h"
#include "tests/support/lookups.h"
#include "tests/support/pruned_configs.h"
#include "tests/support/random.h"

namespace feline {
namespace {

template <Config kConfig>
SamplerState<kConfig> small_state(Mode mode, Wrap wrap) {
  SamplerState<kConfig> state;
  state.mode = state.mode.from_raw(static_cast<std::int64_t>(mode));
  state.wrap_s = state.wrap_t = state.wrap_s.from_raw(static_cast<std::int64_t>(wrap));
  state.width = state.height = state.width.from_raw(1);
  return state;
}

template <Config kConfig>
GroupBeat<kConfig> group_of(const Lookup& lookup, Mode mode, Wrap wrap) {
  return group<kConfig>(make_request<kConfig>(lookup, 0), small_state<kConfig>(mode, wrap));
}

bool is_counted(float value) { return std::fpclassify(value) != FP_ZERO && std::fpclassify(value) != FP_SUBNORMAL; }

// What has no place is 0 to all that follows, and asked for unless it is 0 or a denormal. A footprint without bound has
// what is left of (127, 0), (0, 127).
template <Config kConfig>
void expect_left_out_as_zero(const char* name, Mode mode, Wrap wrap) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for(name);
  constexpr Features kFeatures = kConfig.features;
  int unbounded = 0;
  int asked = 0;
  for (int i = 0; i < 20000; ++i) {
    Lookup lookup = any_lookup(random, 1, 1);
    lookup.s = lookup.t = 0;  // whose range may be another
    Lookup left = lookup;
    bool asks = false;
    const auto leave = [&](bool has_place, float& value) {
      if (has_place) return;
      asks = asks || is_counted(value);
      value = 0;
    };
    leave(kFeatures.dudx, left.dsdx);
    leave(kFeatures.dvdx, left.dtdx);
    leave(kFeatures.dudy, left.dsdy);
    leave(kFeatures.dvdy, left.dtdy);
    const auto got = group_of<kConfig>(lookup, mode, wrap);
    const bool finite = std::isfinite(lookup.dsdx) && std::isfinite(lookup.dtdx) && std::isfinite(lookup.dsdy) &&
                        std::isfinite(lookup.dtdy);
    if (!finite) {
      ++unbounded;
      EXPECT_EQ(got.exponent.raw(), 63);
      EXPECT_EQ(got.dudx.raw(), kFeatures.dudx ? 127 : 0);
      EXPECT_EQ(got.dvdx.raw(), 0);
      EXPECT_EQ(got.dudy.raw(), 0);
      EXPECT_EQ(got.dvdy.raw(), kFeatures.dvdy ? 127 : 0);
      EXPECT_EQ((got.status.raw() & kUnsupported) != 0, asks || !kFeatures.dudx || !kFeatures.dvdy);
      continue;
    }
    asked += asks ? 1 : 0;
    const auto want = group_of<kDefaultConfig>(left, mode, wrap);
    EXPECT_EQ(got.exponent.raw(), want.exponent.raw());
    EXPECT_EQ(got.dudx.raw(), want.dudx.raw());
    EXPECT_EQ(got.dvdx.raw(), want.dvdx.raw());
    EXPECT_EQ(got.dudy.raw(), want.dudy.raw());
    EXPECT_EQ(got.dvdy.raw(), want.dvdy.raw());
    EXPECT_EQ(got.status.raw(), want.status.raw() | unsupported_if(asks));
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << name << ", lookup " << i;
      return;
    }
  }
  EXPECT_GT(unbounded, 100);
  EXPECT_GT(asked, 1000);
}

TEST(group_pruned, derivatives_left_out_are_zero) {
  // Neither ds/dx nor dt/dy; only these.
  expect_left_out_as_zero<kCrossUnit>("model_group.cross", Mode::kTable, Wrap::kRepeat);
  expect_left_out_as_zero<kPlainUnit>("model_group.plain", Mode::kBilinear, Wrap::kClampToEdge);
}

// Of a narrow exponent the ends, and those of the full one, which it says that it lacks.
TEST(group_pruned, narrow_exponents) {
  constexpr Format kExponent = Formats<kSimpleUnit>::kExponent;
  for (int exponent = -70; exponent <= 70; ++exponent) {
    const float derivative = std::ldexp(64.0F, exponent);
    const auto beat = group_of<kSimpleUnit>({0, 0, derivative, 0, 0, 0}, Mode::kSimple, Wrap::kRepeat);
    const bool is_in = exponent >= kExponent.min_raw() && exponent <= kExponent.max_raw();
    const bool is_full = exponent >= -64 && exponent <= 63;
    EXPECT_EQ(beat.exponent.raw(), std::clamp<std::int64_t>(exponent, kExponent.min_raw(), kExponent.max_raw()));
    EXPECT_EQ(beat.dudx.raw(), exponent < kExponent.min_raw() ? 0 : 64) << exponent;
    EXPECT_EQ(beat.status.raw(), unsupported_if(!is_in && (is_full || exponent > 63)) | (exponent > 63 ? kOverflow : 0))
        << exponent;
  }
}

}  // namespace
}  // namespace feline
