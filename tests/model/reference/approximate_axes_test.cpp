// SPDX-License-Identifier: Apache-2.0
#include "model/reference/approximate_axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tests/support/measured.h"
#include "tests/support/random.h"
#include "tests/support/reference_images.h"

namespace feline::reference {
namespace {

constexpr double kPi = std::numbers::pi;
// Erratum 10: the two-part length's exact extremes, where b = 5a/32 and on the diagonal.
const double kMost = std::sqrt(1 + 25.0 / 1024) - 1;
const double kLeast = 179 / (128 * std::sqrt(2.0)) - 1;

TEST(reference_approximate_axes, length_error_extremes) {
  EXPECT_NEAR(kMost, 0.01213, 5e-6);
  EXPECT_NEAR(kLeast, -0.01116, 5e-6);
  double most = -1;
  double least = 1;
  for (int i = 0; i < 1000000; ++i) {
    const double angle = 2 * kPi * i / 1000000;
    const double error = approximate_length({3 * std::cos(angle), 3 * std::sin(angle)}) / 3 - 1;
    most = std::max(most, error);
    least = std::min(least, error);
  }
  EXPECT_NEAR(most, kMost, 1e-10);
  EXPECT_NEAR(least, kLeast, 1e-12);
  EXPECT_NEAR(approximate_length({1, 1}) / std::sqrt(2.0) - 1, kLeast, 1e-15);
  EXPECT_EQ(approximate_length({32, 5}), 32 + 25.0 / 32);
  EXPECT_EQ(approximate_length({-5, 32}), 32 + 25.0 / 32);
  EXPECT_EQ(approximate_length({8, -3}), 109.0 / 16 + 105.0 / 64);  // b < 3a/8 is strict
  EXPECT_EQ(approximate_length({0, 0}), 0);
}

// 3.2 of (13, 0), (12, 5): the diagonal (1, -5) is the shortest, sqrt(26) = 5.099 long, 5 + 5/32 by the two parts.
TEST(reference_approximate_axes, simple_of_the_papers_example) {
  const auto axes = simple_axes({{13, 0}, {12, 5}});
  EXPECT_EQ(axes.major.u, 13);
  EXPECT_EQ(axes.major.v, 0);
  EXPECT_EQ(axes.major_radius, 13);
  EXPECT_EQ(axes.minor_radius, 5 + 5.0 / 32);
  EXPECT_NEAR(axes.minor_radius, 5.099, 0.0122 * 5.099);
}

// 3.2: the longer of both, and the shortest of both and the diagonals, within the length's error of the true lengths.
TEST(reference_approximate_axes, simple_of_any_gradients) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_approximate_axes.simple_of_any_gradients");
  double widest_angle = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto g = random_gradients(random, 8, 8 * random.unit());
    const double x = std::hypot(g.x.u, g.x.v);
    const double y = std::hypot(g.y.u, g.y.v);
    const double shortest =
        std::min({x, y, std::hypot(g.x.u + g.y.u, g.x.v + g.y.v), std::hypot(g.x.u - g.y.u, g.x.v - g.y.v)});
    const auto axes = simple_axes(g);
    EXPECT_GE(axes.major_radius, (1 + kLeast) * std::max(x, y) - 1e-12);
    EXPECT_LE(axes.major_radius, (1 + kMost) * std::max(x, y) + 1e-12);
    EXPECT_GE(axes.minor_radius, (1 + kLeast) * shortest - 1e-12);
    EXPECT_LE(axes.minor_radius, (1 + kMost) * shortest + 1e-12);
    EXPECT_LE(axes.minor_radius, axes.major_radius);
    if (std::max(x, y) < 1.025 * std::min(x, y)) continue;  // the two-part lengths may be the other way round
    EXPECT_EQ(axes.major.u, x > y ? g.x.u : g.y.u);
    EXPECT_EQ(axes.major.v, x > y ? g.x.v : g.y.v);
    widest_angle = std::max(widest_angle, angle_between_lines(axes.major, ellipse_axes(g).major));
  }
  measured("widest_angle", widest_angle * 180 / kPi);
  EXPECT_LE(widest_angle, kPi / 4);         // 2.3: "as much as 45 degrees",
  EXPECT_GE(widest_angle, 35 * kPi / 180);  // and that much as the lengths become equal
}

// 2.3: what Simple guesses never is longer or narrower than the ellipse; along a direction of its own choice the major
// radius of equal parallel vectors is sqrt(2) times as long as guessed, and the minor one wrong by any factor.
TEST(reference_approximate_axes, simple_errs_as_the_paper_says) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_approximate_axes.simple_errs_as_the_paper_says");
  for (int i = 0; i < 100000; ++i) {
    const auto g = random_gradients(random, 5, 5 * random.unit());
    const auto guess = simple_axes(g);
    const auto exact = ellipse_axes(g);
    EXPECT_LE(guess.major_radius, (1 + kMost) * exact.major_radius + 1e-12);
    EXPECT_GE(guess.major_radius * std::sqrt(2.0), (1 + kLeast) * exact.major_radius - 1e-12);
    EXPECT_GE(guess.minor_radius, (1 + kLeast) * exact.minor_radius - 1e-12);
  }
  for (const double height : {1e-2, 1e-4, 1e-8}) {
    const Gradients<double> g{{2, 0}, {1, height}};
    EXPECT_NEAR(simple_axes(g).minor_radius, 1, 1e-2);
    EXPECT_LE(ellipse_axes(g).minor_radius, height);
  }
}

// The true scales of the longer vector by the eigenvalues of M M^T, M = (1, r cos; 0, r sin).
std::array<double, 4> true_scales(double ratio, double angle) {
  const double p = 1 + std::pow(ratio * std::cos(angle), 2);
  const double q = ratio * ratio * std::cos(angle) * std::sin(angle);
  const double r = std::pow(ratio * std::sin(angle), 2);
  const double major = std::sqrt((p + r + std::hypot(p - r, 2 * q)) / 2);
  const double turn = std::atan2(2 * q, p - r) / 2;
  return {major * std::cos(turn), major * std::sin(turn), ratio * std::sin(angle) / major, major};
}

// A table so fine that only what is around it can err (3.3, errata 1 and 2): cell middles, exactly.
EllipseTable fine_table(int size) {
  EllipseTable table{size, size, {}};
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const double quotient = 2 * (column % (size / 2) + 0.5) / size;
      const double angle = column < size / 2 ? std::atan(quotient) : kPi / 2 - std::atan(quotient);
      table.entries.push_back(true_scales((row + 0.5) / size, angle));
    }
  }
  return table;
}

// Errors in units of the longer vector; that of the direction is the arc at the major axis's end, times 1 - (minor /
// major)^2, without which nothing can be said of circles.
struct TableErrors {
  double major, minor, arc;
};
TableErrors worst_errors(Random& random, const EllipseTable* table, bool nearly_round) {
  TableErrors worst{};
  for (int i = 0; i < 100000; ++i) {
    const double minor = nearly_round ? random.real(0.7, 1) : random.real(0, 0.7);
    const auto g = random_gradients(random, 1, minor);
    const auto got = table == nullptr ? table_axes(g) : table_axes(g, *table);
    const auto want = ellipse_axes(g);
    const double longer = std::max(length(g.x), length(g.y));
    const double turn = angle_between_lines(got.major, want.major) * (1 - std::pow(minor, 2));
    worst = {std::max(worst.major, std::abs(got.major_radius - want.major_radius) / longer),
             std::max(worst.minor, std::abs(got.minor_radius - want.minor_radius) / longer),
             std::max(worst.arc, turn * want.major_radius / longer)};
  }
  return worst;
}

void expect_errors(const char* name, const TableErrors& got, const TableErrors& most) {
  measured(std::string(name) + "_major", got.major);
  measured(std::string(name) + "_minor", got.minor);
  measured(std::string(name) + "_arc", got.arc);
  EXPECT_LE(got.major, most.major) << name;
  EXPECT_LE(got.minor, most.minor) << name;
  EXPECT_LE(got.arc, most.arc) << name;
}

// Even a perfect table's radii are multiplied by a length 1.2 % off, up to sqrt(2) times 1.2 %, and its row is chosen
// by a ratio 2.4 % off. A cell of the unit's table is 1/16 of the ratio by 1/8 of the tangent: its middle is within
// half of that, 1/32 and 1/16, of either, and both add up.
TEST(reference_approximate_axes, table_errors) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_approximate_axes.table_errors");
  const auto fine = fine_table(512);
  expect_errors("fine_long", worst_errors(random, &fine, false), {0.02, 0.0125, 0.018});
  expect_errors("fine_round", worst_errors(random, &fine, true), {0.018, 0.016, 0.024});
  expect_errors("unit_long", worst_errors(random, nullptr, false), {0.055, 0.065, 0.058});
  expect_errors("unit_round", worst_errors(random, nullptr, true), {0.063, 0.075, 0.088});
}

// Erratum 1: the axis lies between the longer vector and the side of the line of the shorter that is at an acute angle.
TEST(reference_approximate_axes, table_turns_to_the_shorter_vector) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_approximate_axes.table_turns_to_the_shorter_vector");
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.real(0, 2 * kPi);
    const double between = random.real(0.1, 1.4) * (random.one_in(2) ? 1 : -1);
    const double ratio = random.real(0.3, 0.95);
    const Vector2<double> longer{std::cos(angle), std::sin(angle)};
    const double sign = random.one_in(2) ? 1 : -1;
    const Vector2<double> shorter =
        (sign * ratio) * Vector2<double>{std::cos(angle + between), std::sin(angle + between)};
    const auto axes = random.one_in(2) ? table_axes({longer, shorter}) : table_axes({shorter, longer});
    const double cross = longer.u * axes.major.v - longer.v * axes.major.u;
    const double dot = longer.u * axes.major.u + longer.v * axes.major.v;
    EXPECT_GT(cross * dot * between, 0) << angle << " " << between << " " << ratio;
    EXPECT_LE(std::abs(std::atan2(cross, dot)), std::abs(between)) << angle << " " << between << " " << ratio;
  }
}

TEST(reference_approximate_axes, table_knows_no_signs) {
  const SeedTrace trace(__FILE__, __LINE__);
  Random random = random_for("reference_approximate_axes.table_knows_no_signs");
  for (int i = 0; i < 20000; ++i) {
    const auto g = random_gradients(random, log_uniform(random, -3, 3), random.unit());
    const auto axes = table_axes(g);
    for (const Gradients<double>& same :
         {Gradients<double>{-1.0 * g.x, g.y}, {g.x, -1.0 * g.y}, {-1.0 * g.x, -1.0 * g.y}, {g.y, g.x}}) {
      const auto other = table_axes(same);
      EXPECT_EQ(other.major_radius, axes.major_radius);
      EXPECT_EQ(other.minor_radius, axes.minor_radius);
      EXPECT_LE(angle_between_lines(axes.major, other.major), 1e-15);
    }
  }
}

// Erratum 3. A zero vector's cell is the first; its minor radius is the cell's, at most 1/16 of the longer vector.
TEST(reference_approximate_axes, table_of_degenerate_gradients) {
  for (const auto& g : {Gradients<double>{{3, 4}, {0, 0}}, {{0, 0}, {3, 4}}}) {
    const auto axes = table_axes(g);
    EXPECT_NEAR(axes.major_radius, 5, 0.0122 * 5 + 5.0 / 128);
    EXPECT_GE(axes.minor_radius, 0);
    EXPECT_LE(axes.minor_radius, 1.0122 * 5 / 16);
    EXPECT_NEAR(angle_between_lines(axes.major, {3, 4}), 0, 1.0 / 64);
  }
  const auto none = table_axes({{0, 0}, {0, 0}});
  EXPECT_EQ(none.major_radius, 0);
  EXPECT_EQ(none.minor_radius, 0);
  EXPECT_EQ(length(none.major), 0);
  const auto tie = table_axes({{5, 0}, {0, 5}});  // y is the longer one
  EXPECT_LT(std::abs(tie.major.u), std::abs(tie.major.v));
  for (const double scale : {0x1p-1060, 0x1p-600, 0x1p600, 0x1p1000}) {  // products of which are zero or infinite
    const Gradients<double> g{{13, 0}, {12, 5}};
    const auto far = table_axes({scale * g.x, scale * g.y});
    EXPECT_NEAR(far.major_radius / scale, table_axes(g).major_radius, 0.02);
    EXPECT_NEAR(angle_between_lines({far.major.u / scale, far.major.v / scale}, table_axes(g).major), 0, 2e-3);
  }
  for (const double major : {2.0, 5.0, 11.0}) {  // orthogonal and parallel vectors turn the axis by a cell at most
    const auto right = table_axes({{major, 0}, {0, 1}});
    EXPECT_NEAR(angle_between_lines(right.major, {1, 0}), 0, 1.0 / 16);
    EXPECT_NEAR(right.major_radius, major, major / 32);
    EXPECT_NEAR(right.minor_radius, 1, major / 16);
    const auto parallel = table_axes({{major, 0}, {1, 0}});
    EXPECT_NEAR(angle_between_lines(parallel.major, {1, 0}), 0, 1.0 / 16);
    EXPECT_NEAR(parallel.major_radius, std::hypot(major, 1), major / 16);
    EXPECT_LE(parallel.minor_radius, major / 8);
  }
}

}  // namespace
}  // namespace feline::reference
