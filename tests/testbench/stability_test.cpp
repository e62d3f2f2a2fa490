// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "model/reference/feline.h"
#include "tables/ellipse.h"
#include "testbench/stability/cases.h"
#include "testbench/stability/errors.h"
#include "testbench/stability/jumps.h"
#include "testbench/stability/nonfinite.h"

namespace feline::stability {
namespace {

const CaseClass& class_named(std::string_view name) {
  const auto all = case_classes();
  const auto found = std::ranges::find(all, name, &CaseClass::name);
  EXPECT_NE(found, all.end()) << name;
  return *found;
}

// A case on the first test texture, 256 x 256, from gradients in texels.
Case in_texels(double dudx, double dvdx, double dudy, double dvdy) {
  const auto part = [](double of) { return static_cast<float>(of / 256); };
  return {{0.3F, 0.7F, part(dudx), part(dvdx), part(dudy), part(dvdy)}, 0};
}

// The smaller eigenvalue as a difference, which 200 bits can afford up to a condition number of 1e12.
TEST(stability, truth_is_the_eigenvalues) {
  SplitMix64 random(1);
  for (int i = 0; i < 300; ++i) {
    const auto g = stiff_gradients(random, std::pow(10.0, 12 * random.unit()));
    const reference::Gradients<Real> real{{g.x.u, g.x.v}, {g.y.u, g.y.v}};
    const ExactEllipse got = exact_ellipse(real);
    const Real sum = real.x.u * real.x.u + real.x.v * real.x.v + real.y.u * real.y.u + real.y.v * real.y.v;
    const Real minor_squared = sum - got.major_radius * got.major_radius;
    const Real minor = got.minor_radius * got.minor_radius;
    EXPECT_LT((abs(minor_squared - minor) / minor).to_double(), 1e-30) << i;
    // Against the stable formulas at 200 bits: another way to the same.
    const auto stable = reference::ellipse_axes(real);
    EXPECT_LT((abs(stable.major_radius - got.major_radius) / got.major_radius).to_double(), 1e-55);
    const Real turn = sin(atan2(stable.major.v, stable.major.u) - got.angle);
    EXPECT_LT((abs(turn) * got.axis_weight()).to_double(), 1e-50);
  }
}

TEST(stability, truth_at_the_edges) {
  EXPECT_NEAR(exact_ellipse({{13, 0}, {12, 5}}).major_radius.to_double(), 18.0278, 1e-4);
  EXPECT_NEAR(exact_ellipse({{13, 0}, {12, 5}}).minor_radius.to_double(), 3.6056, 1e-4);
  EXPECT_FALSE(exact_ellipse({{3, 4}, {-4, 3}}).has_axis);
  EXPECT_EQ(exact_ellipse({{0, 0}, {0, 0}}).condition(), 1);
  EXPECT_EQ(exact_ellipse({{1, 2}, {2, 4}}).condition(), INFINITY);
  EXPECT_EQ(exact_ellipse({{0, 0}, {0, -0x1p-149}}).major_radius.to_double(), 0x1p-149);
}

// The line of this study is that of the reference, in double.
TEST(stability, line_is_the_references) {
  const Texture& texture = test_textures().front()->texture();
  reference::MipMap map;
  for (const MipLevel& level : texture.levels) {
    reference::Level& made = map.levels.emplace_back();
    made.width = level.width;
    made.height = level.height;
    for (const std::uint8_t texel : level.texels) made.texels.push_back({static_cast<float>(texel) / 255, 0, 0, 0});
  }
  for (const Case& of : draw_cases(class_named("tame"), 500, 3)) {
    const Lookup& at = of.lookup;
    const reference::Gradients<double> gradients{{at.dsdx, at.dtdx}, {at.dsdy, at.dtdy}};
    const auto axes = reference::ellipse_axes(reference::in_texels(gradients, map.base()));
    const reference::ProbeLine want = reference::plan_feline(axes, reference::kExact, 8);
    const Line<double> got = plan_line(axes, 8);
    ASSERT_EQ(got.probes, want.probes);
    EXPECT_DOUBLE_EQ(clamped_level(got.level, 8), want.level_of_detail);
    EXPECT_DOUBLE_EQ(got.step.u, want.step.u);
    EXPECT_DOUBLE_EQ(got.falloff, want.falloff);
    reference::Cost cost;
    const auto colour = reference::sample_line(map, reference::ProbeKernel::kBilinear, want, {at.s, at.t}, cost);
    EXPECT_NEAR(line_colour(texture, got, double{at.s}, double{at.t}), 255 * colour[0], 1e-4);
  }
}

TEST(stability, classes_are_what_they_claim) {
  constexpr std::uint64_t kCount = 400;
  std::set<int> decades;
  std::set<std::size_t> textures;
  std::set<int> counts;
  int denormals = 0;
  for (const CaseClass& of : case_classes()) {
    const std::string name(of.name);
    const std::vector<Case> cases = draw_cases(of, kCount, 9);
    ASSERT_EQ(cases.size(), kCount);
    for (const Case& drawn : cases) {
      const Lookup& at = drawn.lookup;
      for (const float value : {at.s, at.t, at.dsdx, at.dtdx, at.dsdy, at.dtdy}) ASSERT_TRUE(std::isfinite(value));
      const Truth truth = exact(drawn);
      const double condition = truth.ellipse.condition();
      const double major = truth.ellipse.major_radius.to_double();
      const bool x_zero = at.dsdx == 0 && at.dtdx == 0;
      const bool y_zero = at.dsdy == 0 && at.dtdy == 0;
      const double wanted = truth.line.wanted.to_double();
      const double minor_log2 = std::log2(truth.ellipse.minor_radius.to_double());
      const auto claim = [&](std::string_view which, bool holds) {
        EXPECT_TRUE(which != name || holds) << name << ": condition " << condition << ", major " << major;
      };
      claim("tame", condition < 33);
      claim("nearly_parallel", condition > 1e3);
      claim("nearly_equal", condition > 1e3);
      claim("nearly_round", condition < 1.000002);
      claim("one_zero", x_zero != y_zero);
      claim("both_zero", x_zero && y_zero);
      claim("magnification", major <= 1.0001);
      claim("minification", major >= 127);
      claim("far", std::abs(at.s) >= 1 && std::abs(at.t) >= 1);
      claim("probe_boundary", std::abs(wanted - std::floor(wanted) - 0.5) < 1e-5);
      claim("level_boundary", std::abs(minor_log2 - std::round(minor_log2)) < 1e-5);
      if (name == "condition") decades.insert(static_cast<int>(std::log10(condition)));
      if (name == "size") textures.insert(drawn.texture);
      if (name == "probe_boundary") counts.insert(truth.line.probes);
      denormals += name == "magnification" && major < 0x1p-120 ? 1 : 0;
    }
  }
  for (int decade = 0; decade < 12; ++decade) EXPECT_TRUE(decades.contains(decade)) << decade;
  EXPECT_EQ(textures.size(), test_textures().size() - 1);
  EXPECT_EQ(counts.size(), 16U);
  EXPECT_GT(denormals, 10);
}

TEST(stability, classes_do_not_depend_on_each_other) {
  const auto first = draw_cases(class_named("far"), 5, 1);
  draw_cases(class_named("tame"), 7, 1);
  const auto again = draw_cases(class_named("far"), 5, 1);
  const auto other = draw_cases(class_named("far"), 5, 2);
  EXPECT_EQ(first.back().lookup.s, again.back().lookup.s);
  EXPECT_NE(first.back().lookup.s, other.back().lookup.s);
}

TEST(stability, stiff_gradients_have_the_condition) {
  SplitMix64 random(5);
  for (int i = 0; i < 500; ++i) {
    const double wanted = std::pow(10.0, 13 * random.unit());
    const auto g = stiff_gradients(random, wanted);
    for (const double value : {g.x.u, g.x.v, g.y.u, g.y.v}) {
      EXPECT_EQ(value, std::round(value));
      EXPECT_LE(std::abs(value), 0x1p24);
    }
    const double got = exact_ellipse({{g.x.u, g.x.v}, {g.y.u, g.y.v}}).condition();
    EXPECT_GT(got, wanted / 3);
    EXPECT_LT(got, wanted * 3);
  }
}

double error(Subject subject, Metric metric, const Case& of) {
  const Truth truth = exact(of);
  const Compared compared = compare(subject, of, truth, facts_of(of, truth), evaluate(subject, of));
  return compared.errors[static_cast<std::size_t>(metric)].value_or(-1);
}

// Where the square of the condition number meets the precision, the printed formulas have no digit left and the stable
// ones all of them.
TEST(stability, known_forward_errors) {
  SplitMix64 random(11);
  int lost = 0;
  for (int i = 0; i < 50; ++i) {
    const auto stiff = [&](double condition) {
      const auto g = stiff_gradients(random, condition);
      return in_texels(g.x.u / 4096, g.x.v / 4096, g.y.u / 4096, g.y.v / 4096);
    };
    const Case in_double = stiff(1e10);
    lost += error(Subject::kPrintedDouble, Metric::kMajor, in_double) >= 0.1 ? 1 : 0;
    EXPECT_LT(error(Subject::kStableDouble, Metric::kMinor, in_double), 8 * 0x1p-53);
    EXPECT_LT(error(Subject::kStableDouble, Metric::kMajor, in_double), 6 * 0x1p-53);
    const Case in_float32 = stiff(1e6);
    lost += error(Subject::kPrintedFloat32, Metric::kMajor, in_float32) >= 0.1 ? 1 : 0;
    EXPECT_LT(error(Subject::kStableFloat32, Metric::kMinor, in_float32), 8 * 0x1p-24);
  }
  EXPECT_GE(lost, 95);  // of 100; the others are near by chance
  // At 1e8: diagonal gradients turned by 45 degrees.
  const Case turned = in_texels(100, 100, 100, 100 + 0x1p-20);
  EXPECT_GT(exact(turned).ellipse.condition(), 1e8);
  EXPECT_GE(error(Subject::kPrintedDouble, Metric::kMinor, turned), 1);
  EXPECT_LT(error(Subject::kStableDouble, Metric::kMinor, turned), 8 * 0x1p-53);
}

// As README.md has it: 17.672 and 3.707 for 18.028 and 3.606.
TEST(stability, the_papers_example_in_the_unit) {
  const Case of = in_texels(13, 0, 12, 5);
  EXPECT_NEAR(error(Subject::kUnitTable, Metric::kMajor, of), 0.0197, 1e-3);
  EXPECT_NEAR(error(Subject::kUnitTable, Metric::kMinor, of), 0.028, 1e-3);
  EXPECT_EQ(evaluate(Subject::kUnitTable, of).probes, 9);
  EXPECT_EQ(exact(of).line.probes, 9);
}

// The other side of a boundary is Feline's, too: as long as fProbes is within the radii's bound of it.
TEST(stability, either_side_of_a_boundary_is_right) {
  const Case of = in_texels(5, 0, 0, 2);  // fProbes 4
  const Case at = in_texels(5.5, 0, 0, 2);
  for (const Case& probed : {of, at}) {
    const Truth truth = exact(probed);
    Outcome outcome = evaluate(Subject::kStableDouble, probed);
    outcome.probes = truth.line.probes - 1;
    const Truth other = with_probes(truth, probed, outcome.probes);
    outcome.level = outcome.raw_level = other.level.to_double();
    outcome.colour = other.colour.to_double();
    const Compared compared = compare(Subject::kStableDouble, probed, truth, facts_of(probed, truth), outcome);
    const bool near = probed.lookup.dsdx == at.lookup.dsdx;
    EXPECT_EQ(compared.other_side, near);
    EXPECT_EQ(*compared.errors[static_cast<std::size_t>(Metric::kLevel)] < 1e-12, near);
  }
}

TEST(stability, constants_of_simple_are_its_suprema) {
  constexpr int kLattice = 400;
  double effective = 0;
  double axis = 0;
  for (int i = 0; i <= kLattice; ++i) {
    for (int j = 0; j <= kLattice; ++j) {
      const double u = static_cast<double>(i) / kLattice;
      const double v = static_cast<double>(j) / kLattice;
      if (u * u + v * v > 1) continue;
      const auto ellipse = reference::ellipse_axes<double>({{1, 0}, {u, v}});
      const double shortest = std::min(std::hypot(u, v), std::hypot(1 - u, v));
      effective = std::max(effective, shortest / std::max(ellipse.minor_radius, 2 * ellipse.major_radius / 17));
      const double ratio = ellipse.minor_radius / ellipse.major_radius;
      axis = std::max(axis, std::abs(ellipse.major.v) / ellipse.major_radius * (1 - ratio * ratio));
      EXPECT_GE(1 / ellipse.major_radius, kSimpleMajorLow * (1 - 1e-8));
      EXPECT_GE(shortest, ellipse.minor_radius * (1 - 1e-12));
    }
  }
  EXPECT_LE(effective, kSimpleEffectiveHigh);
  EXPECT_GE(effective, kSimpleEffectiveHigh - 0.02);
  EXPECT_LE(axis, kSimpleAxis);
  EXPECT_GE(axis, kSimpleAxis - 0.003);
}

TEST(stability, constant_of_table_is_its_supremum) {
  constexpr int kLattice = 8;
  const Rom rom = ellipse_rom(kDefaultConfig);
  double axis = 0;
  for (std::size_t word = 0; word < rom.words.size(); ++word) {
    const auto entry = entry_scales(kDefaultConfig, rom.words[word]);
    const int row = static_cast<int>(word) / kDefaultConfig.table_columns;
    const int column = static_cast<int>(word) % kDefaultConfig.table_columns;
    for (int x = 0; x <= kLattice; ++x) {
      for (int y = 0; y <= kLattice; ++y) {
        const auto real =
            ellipse_scales(kDefaultConfig.table_rows, kDefaultConfig.table_columns, {row, column, x, y, kLattice});
        const double turn = std::atan2(entry[1], entry[0]) - std::atan2(real[1].middle(), real[0].middle());
        const double ratio = real[2].middle() / real[3].middle();
        axis = std::max(axis, std::abs(std::sin(turn)) * (1 - ratio * ratio));
      }
    }
  }
  EXPECT_LE(axis, kTableAxis);
  EXPECT_GE(axis, kTableAxis - 0.003);
}

TEST(stability, numbers_that_are_not_finite) {
  for (const NonFiniteRow& row : run_non_finite(2)) {
    EXPECT_GE(row.count, 64U);
    EXPECT_TRUE(row.holds(Subject::kUnitSimple)) << row.what;
    EXPECT_TRUE(row.holds(Subject::kUnitTable)) << row.what;
  }
}

}  // namespace
}  // namespace feline::stability
