// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/cases.h"

#include <array>
#include <cmath>
#include <numeric>

namespace feline::stability {
namespace {

using RealGradients = reference::Gradients<double>;

double between(SplitMix64& random, double low, double high) { return low + (high - low) * random.unit(); }
double sign(SplitMix64& random) { return random.chance(0.5) ? -1 : 1; }
// Of either sign, and each octave as likely as another.
double signed_power(SplitMix64& random, double low_log2, double high_log2) {
  const double flip = sign(random);
  return flip * std::exp2(between(random, low_log2, high_log2));
}
float step(float value, int ulps) {
  for (; ulps > 0; --ulps) value = std::nextafter(value, INFINITY);
  for (; ulps < 0; ++ulps) value = std::nextafter(value, -INFINITY);
  return value;
}
int few(SplitMix64& random) { return static_cast<int>(random.below(7)) - 3; }

// Texels of the class' texture to a lookup, rounded to float32.
Case case_of(SplitMix64& random, const RealGradients& texels, std::size_t texture = 0) {
  Case of;
  of.texture = texture;
  const double width = texture_of(of).width();
  const double height = texture_of(of).height();
  of.lookup = {static_cast<float>(random.unit()),      static_cast<float>(random.unit()),
               static_cast<float>(texels.x.u / width), static_cast<float>(texels.x.v / height),
               static_cast<float>(texels.y.u / width), static_cast<float>(texels.y.v / height)};
  return of;
}

// Radii `major` and `major`/condition, at any angle, mixed by any rotation of the pixel.
RealGradients ellipse(SplitMix64& random, double major, double condition) {
  const double angle = between(random, 0, 6.283185307179586);
  const double mix = between(random, 0, 6.283185307179586);
  const double minor = major / condition;
  const auto column = [&](double along, double across) {
    return reference::Vector2<double>{along * std::cos(angle) - across * std::sin(angle),
                                      along * std::sin(angle) + across * std::cos(angle)};
  };
  return {column(major * std::cos(mix), minor * std::sin(mix)), column(-major * std::sin(mix), minor * std::cos(mix))};
}

RealGradients any_ellipse(SplitMix64& random, double low_log2, double high_log2, double most_condition_log2) {
  const double condition = std::exp2(between(random, 0, most_condition_log2));
  return ellipse(random, std::exp2(between(random, low_log2, high_log2)), condition);
}

Case tame(SplitMix64& random) { return case_of(random, any_ellipse(random, -2, 7, 5)); }

Case condition(SplitMix64& random) {
  RealGradients texels = stiff_gradients(random, std::pow(10.0, between(random, 0, 12)));
  // Powers of two change no condition.
  const double scale = std::ldexp(1.0, -10 - static_cast<int>(random.below(14)));
  return case_of(random, {scale * texels.x, scale * texels.y});
}

Case nearly_parallel(SplitMix64& random) {
  Case of = tame(random);
  const auto part = static_cast<float>(between(random, -1, 1));
  of.lookup.dsdy = step(of.lookup.dsdx * part, few(random));
  of.lookup.dtdy = step(of.lookup.dtdx * part, few(random));
  return of;
}

Case nearly_equal(SplitMix64& random) {
  Case of = tame(random);
  const auto flip = static_cast<float>(sign(random));
  of.lookup.dsdy = step(of.lookup.dsdx * flip, few(random));
  of.lookup.dtdy = step(of.lookup.dtdx * flip, few(random));
  return of;
}

Case nearly_round(SplitMix64& random) {
  Case of = tame(random);
  const auto flip = static_cast<float>(sign(random));
  of.lookup.dsdy = step(-of.lookup.dtdx * flip, few(random));
  of.lookup.dtdy = step(of.lookup.dsdx * flip, few(random));
  return of;
}

Case one_zero(SplitMix64& random) {
  Case of = case_of(random, any_ellipse(random, -20, 20, 5));
  (random.chance(0.5) ? of.lookup.dsdx : of.lookup.dsdy) = 0;
  (of.lookup.dsdx == 0 ? of.lookup.dtdx : of.lookup.dtdy) = 0;
  return of;
}

Case both_zero(SplitMix64& random) {
  Case of = tame(random);
  const auto zero = [&] { return random.chance(0.5) ? 0.0F : -0.0F; };
  of.lookup.dsdx = zero(), of.lookup.dtdx = zero(), of.lookup.dsdy = zero(), of.lookup.dtdy = zero();
  return of;
}

// Down to denormals, and up to where texels of a 256 x 256 texture no longer fit float32.
Case magnification(SplitMix64& random) { return case_of(random, any_ellipse(random, -141, 0, 5)); }
Case minification(SplitMix64& random) { return case_of(random, any_ellipse(random, 7, 134, 5)); }

Case uneven(SplitMix64& random) {
  const auto component = [&] { return signed_power(random, -120, 120); };
  RealGradients texels{{component(), component()}, {component(), component()}};
  return case_of(random, texels);
}

Case size(SplitMix64& random) {
  const std::size_t texture = 1 + random.below(static_cast<std::uint32_t>(test_textures().size() - 1));
  return case_of(random, any_ellipse(random, -3, 15, 8), texture);
}

Case far_away(SplitMix64& random) {
  Case of = tame(random);
  const auto far = [&] { return static_cast<float>(signed_power(random, 0, 24)); };
  of.lookup.s = far();
  of.lookup.t = far();
  return of;
}

// Aligned or turned by a right angle, so that the radii are the float32 components themselves.
Case aligned(SplitMix64& random, float major, float minor) {
  Case of = tame(random);
  Lookup& at = of.lookup;
  at.dsdx = at.dtdx = at.dsdy = at.dtdy = 0;
  const bool along_s = random.chance(0.5);
  const bool x_is_longer = random.chance(0.5);
  const auto flip = static_cast<float>(sign(random));
  (x_is_longer ? (along_s ? at.dsdx : at.dtdx) : (along_s ? at.dsdy : at.dtdy)) = flip * major / 256;
  (x_is_longer ? (along_s ? at.dtdy : at.dsdy) : (along_s ? at.dtdx : at.dsdx)) = minor / 256;
  return of;
}

// fProbes = 2 major/minor - 1 = n + 1/2.
Case probe_boundary(SplitMix64& random) {
  const auto minor = static_cast<float>(std::exp2(static_cast<double>(random.below(5))));
  const auto probes = static_cast<float>(1 + random.below(kMaxProbes - 1));
  return aligned(random, step(minor * (probes + 1.5F) / 2, static_cast<int>(random.below(3)) - 1), minor);
}

// A level that is a whole number, one texel and the 1 x 1 level included.
Case level_boundary(SplitMix64& random) {
  const auto minor = static_cast<float>(std::exp2(static_cast<double>(random.below(10))));
  const auto ratio = static_cast<float>(random.chance(0.5) ? 1 : between(random, 1, 8));
  return aligned(random, minor * ratio, step(minor, static_cast<int>(random.below(3)) - 1));
}

constexpr std::array kClasses{
    CaseClass{"tame", "1/4 to 128 texels, condition number 1 to 32, any angle: what a scene asks for", tame},
    CaseClass{"condition", "condition number 1 to 1e12, exact in float32 components, 1/2 to 16384 texels", condition},
    CaseClass{"nearly_parallel", "one gradient a multiple of the other, off by up to 3 ulp a component",
              nearly_parallel},
    CaseClass{"nearly_equal", "equal or opposite gradients, off by up to 3 ulp a component", nearly_equal},
    CaseClass{"nearly_round", "gradients of equal length at right angles, off by up to 3 ulp a component",
              nearly_round},
    CaseClass{"one_zero", "one gradient zero, the other 2^-20 to 2^20 texels", one_zero},
    CaseClass{"both_zero", "both gradients zero, of either sign", both_zero},
    CaseClass{"magnification", "2^-141 to 1 texel: float32 derivatives down to the denormals", magnification},
    CaseClass{"minification", "2^7 to 2^134 texels: float32 derivatives up to 2^126, beyond float32 in texels",
              minification},
    CaseClass{"uneven", "each component 2^-120 to 2^120 texels on its own", uneven},
    CaseClass{"size", "textures of 16384 x 16, 16384 x 1, 16383 x 11, 1000 x 7, 3 x 5, 2 x 1, 1 x 1 and upright", size},
    CaseClass{"far", "tame, at coordinates of 1 to 2^24 textures", far_away},
    CaseClass{"probe_boundary", "fProbes at n + 1/2 for n = 1 to 15, and an ulp to either side", probe_boundary},
    CaseClass{"level_boundary",
              "minor radius a power of two, one texel and the 1 x 1 level included, and an ulp to either side",
              level_boundary},
};

// g = a x + b y for the greatest common divisor g.
struct Bezout {
  std::int64_t g, x, y;
};
Bezout bezout(std::int64_t a, std::int64_t b) {
  std::array<std::int64_t, 3> now{a, 1, 0};
  std::array<std::int64_t, 3> next{b, 0, 1};
  while (next[0] != 0) {
    const std::int64_t quotient = now[0] / next[0];
    for (std::size_t i = 0; i < 3; ++i) now[i] -= quotient * next[i];
    std::swap(now, next);
  }
  return {now[0], now[1], now[2]};
}

}  // namespace

RealGradients stiff_gradients(SplitMix64& random, double condition) {
  constexpr std::int64_t kMost = std::int64_t{1} << 23;
  // Below this, rounding to 24 bits moves the condition by little.
  if (condition < 1000) {
    const RealGradients real = ellipse(random, kMost, condition);
    const auto rounded = [](const reference::Vector2<double>& v) {
      return reference::Vector2<double>{std::round(v.u), std::round(v.v)};
    };
    return {rounded(real.x), rounded(real.y)};
  }
  // x = (a, b) with a and b relatively prime, and y = (c, d) such that a d - b c is what the condition asks for.
  std::int64_t a = 0;
  std::int64_t b = 0;
  do {
    a = kMost / 2 + random.below(static_cast<std::uint32_t>(kMost / 2));
    b = random.below(static_cast<std::uint32_t>(kMost)) + 1;
  } while (std::gcd(a, b) != 1);
  // The larger eigenvalue is about 4/3 of |x|^2, as c is anywhere within -a .. a.
  const double length =
      static_cast<double>(a) * static_cast<double>(a) + static_cast<double>(b) * static_cast<double>(b);
  const auto determinant = std::max<std::int64_t>(std::llround(length * 4 / 3 / condition), 1);
  const Bezout solved = bezout(a, b);
  // a (determinant x) + b (determinant y) = determinant: c = t a - determinant y, d = t b + determinant x for any t.
  const __int128 product = static_cast<__int128>(determinant) * solved.y;
  const auto c = static_cast<std::int64_t>(-(product % a));
  const auto d = static_cast<std::int64_t>(static_cast<__int128>(determinant) * solved.x + product / a * b);
  const double flip = sign(random);
  const RealGradients all{{flip * static_cast<double>(a), static_cast<double>(b)},
                          {flip * static_cast<double>(c), static_cast<double>(d)}};
  return random.chance(0.5) ? all : RealGradients{{all.x.v, all.x.u}, {all.y.v, all.y.u}};
}

std::span<const CaseClass> case_classes() { return kClasses; }

std::vector<Case> draw_cases(const CaseClass& of, std::uint64_t count, std::uint64_t seed) {
  // From the name, so that the order of the classes says nothing.
  std::uint64_t part = 0;
  for (const char c : of.name) part = 31 * part + static_cast<std::uint64_t>(c);
  SplitMix64 random(derived_seed(seed, part));
  std::vector<Case> cases;
  for (std::uint64_t i = 0; i < count; ++i) cases.push_back(of.draw(random));
  return cases;
}

}  // namespace feline::stability
