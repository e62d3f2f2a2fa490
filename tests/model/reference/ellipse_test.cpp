// SPDX-License-Identifier: Apache-2.0
#include "model/reference/ellipse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "testbench/stability/real.h"
#include "tests/support/measured.h"
#include "tests/support/random.h"
#include "tests/support/reference_images.h"

namespace feline::reference {
namespace {

// The ellipse by the eigenvalues of M M^T in 200 bits, M the matrix whose columns are the gradients.
struct TrueAxes {
  Real major, minor, angle;
};
TrueAxes true_axes(const Gradients<double>& g) {
  const Real p = Real(g.x.u) * g.x.u + Real(g.y.u) * g.y.u;
  const Real q = Real(g.x.u) * g.x.v + Real(g.y.u) * g.y.v;
  const Real r = Real(g.x.v) * g.x.v + Real(g.y.v) * g.y.v;
  const Real root = sqrt((p - r) * (p - r) + Real(4) * q * q);
  const Real half = Real::ratio(1, 2);
  return {sqrt((p + r + root) * half), sqrt((p + r - root) * half), half * atan2(Real(2) * q, p - r)};
}

double relative(double got, const Real& want) { return std::abs(((Real(got) - want) / want).to_double()); }

// Between two lines, in radians.
double angle_error(const Vector2<double>& got, const Real& angle) {
  const Real cross = Real(got.v) * cos(angle) - Real(got.u) * sin(angle);
  return std::abs((cross / sqrt(Real(got.u) * got.u + Real(got.v) * got.v)).to_double());
}

// Conditions of 1 to 10^12 and scales of 10^-30 to 10^30. Relative errors measured: major radius 3.1e-16, minor
// 4.6e-16; direction 5.2e-16 radians times 1/(1 - (minor/major)^2), its condition.
TEST(reference_ellipse, axes_against_eigenvalues_in_200_bits) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_ellipse.axes_against_eigenvalues_in_200_bits");
  double worst_major = 0;
  double worst_minor = 0;
  double worst_turn = 0;
  for (int i = 0; i < 40000; ++i) {
    const double scale = log_uniform(random, -30, 30);
    const double condition = i % 4 == 0 ? 1 + log_uniform(random, -12, 0) : log_uniform(random, 0, 12);
    const Gradients<double> g = random_gradients(random, scale, scale / condition);
    const auto got = ellipse_axes(g);
    const TrueAxes want = true_axes(g);
    const double eccentric = (Real(1) - want.minor * want.minor / (want.major * want.major)).to_double();
    worst_major = std::max(worst_major, relative(got.major_radius, want.major));
    worst_minor = std::max(worst_minor, relative(got.minor_radius, want.minor));
    worst_turn = std::max(worst_turn, eccentric * angle_error(got.major, want.angle));
    EXPECT_NEAR(length(got.major) / got.major_radius, 1, 1e-15);
    EXPECT_LE(got.minor_radius, got.major_radius);
  }
  measured("worst_major", worst_major);
  measured("worst_minor", worst_minor);
  measured("worst_turn", worst_turn);
  EXPECT_LE(worst_major, 6e-16);
  EXPECT_LE(worst_minor, 9e-16);
  EXPECT_LE(worst_turn, 1e-15);
}

// WRL 99/1, 2.3: (13, 0) and (12, 5). M M^T = (313 60, 60 25) has the eigenvalues 169 +- 156.
TEST(reference_ellipse, the_papers_example) {
  const Gradients<double> g{{13, 0}, {12, 5}};
  const auto axes = ellipse_axes(g);
  EXPECT_LE(relative(axes.major_radius, sqrt(Real(325))), 1e-15);
  EXPECT_LE(relative(axes.minor_radius, sqrt(Real(13))), 1e-15);
  EXPECT_NEAR(axes.major_radius, 18.028, 5e-4);
  EXPECT_NEAR(axes.minor_radius, 3.606, 5e-4);
  EXPECT_NEAR(2 * axes.major_radius / axes.minor_radius - 1, 9, 1e-14);
  EXPECT_LE(std::abs(axes.major.u - 5 * axes.major.v), 1e-14);  // the eigenvector (60, 325 - 313)
}

// 2.1: negated or exchanged gradients are the same ellipse.
TEST(reference_ellipse, symmetric) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_ellipse.symmetric");
  for (int i = 0; i < 20000; ++i) {
    const double scale = log_uniform(random, -6, 6);
    const auto g = random_gradients(random, scale, scale * random.unit());
    const auto axes = ellipse_axes(g);
    const Vector2<double> minus_x{-g.x.u, -g.x.v};
    const Vector2<double> minus_y{-g.y.u, -g.y.v};
    for (const Gradients<double>& same :
         {Gradients<double>{minus_x, g.y}, {g.x, minus_y}, {minus_x, minus_y}, {g.y, g.x}, {minus_y, g.x}}) {
      const auto other = ellipse_axes(same);
      EXPECT_NEAR(other.major_radius / axes.major_radius, 1, 4e-16);
      EXPECT_NEAR(other.minor_radius / axes.minor_radius, 1, 1e-15);
      const double eccentric = 1 - std::pow(axes.minor_radius / axes.major_radius, 2);
      EXPECT_LE(eccentric * angle_between_lines(axes.major, other.major), 3e-15);
    }
    // A mirrored plane mirrors the axis.
    const auto mirrored = ellipse_axes<double>({{g.x.u, -g.x.v}, {g.y.u, -g.y.v}});
    EXPECT_LE(angle_between_lines({axes.major.u, -axes.major.v}, mirrored.major) *
                  (1 - std::pow(axes.minor_radius / axes.major_radius, 2)),
              3e-15);
  }
}

TEST(reference_ellipse, degenerate_gradients) {
  const auto none = ellipse_axes<double>({{0, 0}, {0, 0}});
  EXPECT_EQ(none.major_radius, 0);
  EXPECT_EQ(none.minor_radius, 0);
  EXPECT_EQ(none.major.u, 0);
  EXPECT_EQ(none.major.v, 0);
  const auto circle = ellipse_axes<double>({{0, 7}, {-7, 0}});
  EXPECT_EQ(circle.major_radius, 7);
  EXPECT_EQ(circle.minor_radius, 7);
  EXPECT_NEAR(length(circle.major), 7, 1e-14);
  for (const double part : {0.0, 0.5, -2.0, 4.0}) {  // parallel: a line of no width, sqrt(1 + part^2) long
    const auto line = ellipse_axes<double>({{3, 4}, {3 * part, 4 * part}});
    EXPECT_EQ(line.minor_radius, 0) << part;
    EXPECT_NEAR(line.major_radius, 5 * std::hypot(1, part), 1e-14 * line.major_radius) << part;
    EXPECT_NEAR(angle_between_lines(line.major, {3, 4}), 0, 1e-15) << part;
  }
  // Where A = C, the printed arctan(B/(A - C))/2 has no value (erratum 4).
  const auto diagonal = ellipse_axes<double>({{2, 1}, {1, 2}});
  EXPECT_NEAR(diagonal.major_radius, 3, 1e-15);
  EXPECT_NEAR(diagonal.minor_radius, 1, 1e-15);
  EXPECT_NEAR(angle_between_lines(diagonal.major, {1, 1}), 0, 1e-15);
  for (const double scale : {0x1p-1000, 0x1p+1000}) {
    const auto far = ellipse_axes<double>({{13 * scale, 0}, {12 * scale, 5 * scale}});
    EXPECT_NEAR(far.major_radius / scale, std::sqrt(325.0), 1e-14);
    EXPECT_NEAR(far.minor_radius / scale, std::sqrt(13.0), 1e-14);
  }
}

// 2.1: d is the distance from the middle in the screen, so that d = 1 on the image of the pixel filter's circle.
TEST(reference_ellipse, printed_coefficients_are_the_image_of_the_circle) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_ellipse.printed_coefficients_are_the_image_of_the_circle");
  for (int i = 0; i < 20000; ++i) {
    const double major = log_uniform(random, -3, 3);
    const double condition = log_uniform(random, 0, 2);
    const auto g = random_gradients(random, major, major / condition);
    const auto q = ellipse_coefficients(g, 0.0);
    const double phase = random.real(0, 2 * std::numbers::pi);
    const double radius = random.real(0.1, 2);
    const Vector2<double> p = (radius * std::cos(phase)) * g.x + (radius * std::sin(phase)) * g.y;
    const double bound = 1e-14 * condition * condition;
    EXPECT_NEAR((q.a * p.u * p.u + q.b * p.u * p.v + q.c * p.v * p.v) / (radius * radius), 1, bound);
    // The code that 2.1 and 3.1 print gives the same axes, losing the square of the condition.
    const auto printed = printed_axes(q);
    const auto exact = ellipse_axes(g);
    EXPECT_NEAR(printed.major_radius / exact.major_radius, 1, bound);
    EXPECT_NEAR(printed.minor_radius / exact.minor_radius, 1, bound);
    if (condition > 1.1) {
      EXPECT_LE(angle_between_lines(printed.major, exact.major), bound / (1 - 1 / condition));
    }
  }
}

// 3.1: Heckbert's union adds 1 to both squares, and so to both squared radii; a one-to-one mapping gives sqrt(2).
TEST(reference_ellipse, widened_radii) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_ellipse.widened_radii");
  for (int i = 0; i < 10000; ++i) {
    const double major = log_uniform(random, -1, 1.5);
    const double minor = major * random.unit();
    const auto wide = printed_axes(ellipse_coefficients(random_gradients(random, major, minor), 1.0));
    EXPECT_NEAR(wide.major_radius, std::hypot(major, 1), 1e-11 * wide.major_radius);
    EXPECT_NEAR(wide.minor_radius, std::hypot(minor, 1), 1e-11);
  }
  const auto unity = printed_axes(ellipse_coefficients<double>({{1, 0}, {0, 1}}, 1.0));
  EXPECT_NEAR(unity.major_radius, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(unity.minor_radius, std::sqrt(2.0), 1e-15);
  const auto magnified = printed_axes(ellipse_coefficients<double>({{1e-9, 0}, {0, 1e-9}}, 1.0));
  EXPECT_NEAR(magnified.major_radius, 1, 1e-15);
}

}  // namespace
}  // namespace feline::reference
