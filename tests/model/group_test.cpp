// SPDX-License-Identifier: Apache-2.0
#include "model/group.h"

#include <gtest/gtest.h>

#include "tests/support/describe.h"
#include "tests/support/lookups.h"
#include "tests/support/oracle.h"
#include "tests/support/samplers.h"

namespace feline {
namespace {

State wrapped_state(int width, int height, Wrap wrap_s, Wrap wrap_t, Mode mode = Mode::kTable) {
  SamplerOptions options;
  options.mode = mode;
  options.wrap_s = wrap_s;
  options.wrap_t = wrap_t;
  return oracle::sampler_state(options, TexelFormat::kR8, false, width, height, 1, {});
}

GroupBeat<kDefaultConfig> group_of(const Lookup& lookup, const State& state) {
  return group<kDefaultConfig>(make_request<kDefaultConfig>(lookup, 7), state);
}

void expect_as_oracle(const Lookup& lookup, const State& state) {
  const auto request = make_request<kDefaultConfig>(lookup, 0x1234);
  const auto got = group<kDefaultConfig>(request, state);
  const auto want = oracle::group(request, state);
  ASSERT_TRUE(same(got, want)) << mismatch(got, want, request, state);
}

// 1,000,000 lookups, a quarter of each kind, on random sizes and wrap modes.
TEST(group, equals_exact_arithmetic) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("model_group.equals_exact_arithmetic");
  for (int i = 0; i < 1000000 && !HasFatalFailure(); ++i) {
    const int width = static_cast<int>(random.between(1, 1 << random.between(0, 14)));
    const int height = static_cast<int>(random.between(1, 1 << random.between(0, 14)));
    const State state = wrapped_state(width, height, static_cast<Wrap>(random.below(4)),
                                      static_cast<Wrap>(random.below(4)), static_cast<Mode>(random.below(6)));
    expect_as_oracle(any_lookup(random, width, height), state);
  }
}

// Every pair of the float lattice in every pair of the six operands, the others tame; all wrap modes.
TEST(group, lattice_of_every_float_class_in_pairs) {
  for (int first = 0; first < 6; ++first) {
    for (int second = first + 1; second < 6; ++second) {
      for (const auto a : kFloatLattice) {
        for (const auto b : kFloatLattice) {
          std::array<float, 6> operand{0.25F, 0.75F, 0.013F, -0.007F, 0.002F, 0.011F};
          operand[static_cast<std::size_t>(first)] = float_of(a);
          operand[static_cast<std::size_t>(second)] = float_of(b);
          const Lookup lookup{operand[0], operand[1], operand[2], operand[3], operand[4], operand[5]};
          for (int wrap = 0; wrap < 4; ++wrap) {
            const auto mode = static_cast<Wrap>(wrap);
            expect_as_oracle(lookup, wrapped_state(16384, 37, mode, static_cast<Wrap>(3 - wrap)));
            if (HasFatalFailure()) return;
          }
        }
      }
    }
  }
}

// Feline's modes: half a unit counts, and 127.5 moves the exponent; then all are rounded anew.
TEST(group, rounds_mantissas_to_nearest) {
  for (const Mode mode : {Mode::kSimple, Mode::kTable}) {
    const State state = wrapped_state(1, 1, Wrap::kRepeat, Wrap::kRepeat, mode);
    const auto below = group_of({0, 0, std::nextafter(127.5F, 0.0F), std::nextafter(2.5F, 0.0F), -2.5F, 0.5F}, state);
    EXPECT_EQ(below.exponent.raw(), 0);
    EXPECT_EQ(below.dudx.raw(), 127);
    EXPECT_EQ(below.dvdx.raw(), 2);
    EXPECT_EQ(below.dudy.raw(), -3);
    EXPECT_EQ(below.dvdy.raw(), 1);
    const auto beyond = group_of({0, 0, 127.5F, 2.5F, -3, 1e-30F}, state);
    EXPECT_EQ(beyond.exponent.raw(), 1);
    EXPECT_EQ(beyond.dudx.raw(), 64);
    EXPECT_EQ(beyond.dvdx.raw(), 1);
    EXPECT_EQ(beyond.dudy.raw(), -2);
    EXPECT_EQ(beyond.dvdy.raw(), 0);
  }
}

// The other modes: a unit in the last place beyond a mantissa counts, and 127 + epsilon moves the exponent.
TEST(group, rounds_mantissas_outward) {
  const State state = wrapped_state(1, 1, Wrap::kRepeat, Wrap::kRepeat, Mode::kTrilinear);
  const auto exact = group_of({0, 0, 100, 13, -5, 0}, state);
  EXPECT_EQ(exact.exponent.raw(), 0);
  EXPECT_EQ(exact.dudx.raw(), 100);
  EXPECT_EQ(exact.dvdx.raw(), 13);
  EXPECT_EQ(exact.dudy.raw(), -5);
  EXPECT_EQ(exact.dvdy.raw(), 0);
  const auto more = group_of({0, 0, std::nextafter(100.0F, 200.0F), 1e-20F, -5.0001F, -1e-30F}, state);
  EXPECT_EQ(more.dudx.raw(), 101);
  EXPECT_EQ(more.dvdx.raw(), 1);
  EXPECT_EQ(more.dudy.raw(), -6);
  EXPECT_EQ(more.dvdy.raw(), -1);
  EXPECT_EQ(group_of({0, 0, 127, 0, 0, 0}, state).exponent.raw(), 0);
  const auto beyond = group_of({0, 0, std::nextafter(127.0F, 200.0F), 3, 0, 0}, state);
  EXPECT_EQ(beyond.exponent.raw(), 1);
  EXPECT_EQ(beyond.dudx.raw(), 64);
  EXPECT_EQ(beyond.dvdx.raw(), 2);
}

TEST(group, unbounded_and_tiny_footprints) {
  const State state = wrapped_state(256, 256, Wrap::kRepeat, Wrap::kClampToEdge, Mode::kTrilinear);
  for (const auto bits : {0x7f800000U, 0xff800000U, 0x7fc00000U, 0xffffffffU}) {
    for (int operand = 0; operand < 4; ++operand) {
      std::array<float, 4> derivative{0.1F, -0.2F, 0, 1};
      derivative[static_cast<std::size_t>(operand)] = float_of(bits);
      const auto beat = group_of({0.5F, 0.5F, derivative[0], derivative[1], derivative[2], derivative[3]}, state);
      EXPECT_EQ(beat.exponent.raw(), 63);
      EXPECT_EQ(beat.dudx.raw(), 127);
      EXPECT_EQ(beat.dvdx.raw(), 0);
      EXPECT_EQ(beat.dudy.raw(), 0);
      EXPECT_EQ(beat.dvdy.raw(), 127);
      EXPECT_EQ(beat.status.raw(), kDerivativeNotFinite);
    }
  }
  const auto tiny = group_of({0, 0, 0x1p-100F, 0, 0, -0x1p-120F}, state);
  EXPECT_EQ(tiny.exponent.raw(), -64);
  EXPECT_EQ(tiny.dudx.raw(), 0);
  const auto denormal = group_of({0, 0, 0x1p-130F, 0, 0, 0x1p-149F}, state);
  EXPECT_EQ(denormal.dudx.raw(), 0);
  EXPECT_EQ(denormal.status.raw(), 0);
  // The coarsest exponent, and one unit in the last place more, which is said to overflow.
  const auto greatest = group_of({0, 0, 0x1.fcp61F, 0, 0, 0}, state);
  EXPECT_EQ(greatest.exponent.raw(), 63);
  EXPECT_EQ(greatest.dudx.raw(), 127);
  EXPECT_EQ(greatest.status.raw(), 0);
  const auto overflow = group_of({0, 0, std::nextafter(0x1.fcp61F, 1e30F), 0, 0, 0}, state);
  EXPECT_EQ(overflow.exponent.raw(), 63);
  EXPECT_EQ(overflow.status.raw(), kOverflow);
  // The finest exponent: 64 * 2^-64 texels.
  const auto least = group_of({0, 0, 0x1p-66F, 0, 0, 0}, state);
  EXPECT_EQ(least.exponent.raw(), -64);
  EXPECT_EQ(least.dudx.raw(), 64);
}

TEST(group, coordinates_saturate_wrap_and_round) {
  const State repeat = wrapped_state(256, 256, Wrap::kRepeat, Wrap::kMirroredRepeat);
  const State clamp = wrapped_state(256, 256, Wrap::kClampToEdge, Wrap::kClampToBorder);
  constexpr std::int64_t kOne = 1 << 24;
  const auto s = [](float value, const State& state) { return group_of({value, value, 0, 0, 0, 0}, state).s.raw(); };
  const auto t = [](float value, const State& state) { return group_of({value, value, 0, 0, 0, 0}, state).t.raw(); };
  EXPECT_EQ(s(0.5F, repeat), kOne / 2);
  EXPECT_EQ(s(-1.25F, clamp), -kOne * 5 / 4);
  EXPECT_EQ(s(0x1p-25F, repeat), 1);  // ties away from zero
  EXPECT_EQ(s(-0x1p-25F, repeat), -1);
  EXPECT_EQ(s(0x1.8p-24F, repeat), 2);
  EXPECT_EQ(s(std::nextafter(0x1p-25F, 0.0F), repeat), 0);
  EXPECT_EQ(s(0x1p19F, clamp), kOne << 19);
  EXPECT_EQ(s(0x1p60F, clamp), kOne << 19);
  EXPECT_EQ(t(-INFINITY, clamp), -(kOne << 19));
  EXPECT_EQ(s(INFINITY, repeat), 0);
  EXPECT_EQ(t(NAN, clamp), 0);
  EXPECT_EQ(s(0x1p20F, repeat), -(kOne << 20));  // modulo 2^21
  EXPECT_EQ(s(-0x1p39F, repeat), 0);
  EXPECT_EQ(s(0x1.000002p20F, repeat), -(kOne << 20) + kOne / 8);
  const auto status = [](float s, float t, const State& state) {
    return group_of({s, t, 0, 0, 0, 0}, state).status.raw();
  };
  EXPECT_EQ(status(0x1p19F, 0, clamp), kOverflow);
  EXPECT_EQ(status(0, -0x1p100F, clamp), kOverflow);
  EXPECT_EQ(status(std::nextafter(0x1p19F, 0.0F), 0, clamp), 0);
  EXPECT_EQ(status(0x1p100F, -0x1p100F, repeat), 0);
  EXPECT_EQ(status(INFINITY, 0, clamp), kCoordinateNotFinite);
  EXPECT_EQ(status(0x1p20F, NAN, clamp), kOverflow | kCoordinateNotFinite);
}

}  // namespace
}  // namespace feline
