// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/jumps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "testbench/stability/bounds.h"
#include "testbench/stability/cases.h"

namespace feline::stability {
namespace {

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }
float value(std::uint32_t of) { return std::bit_cast<float>(of); }

// Gradients in texels of the first test texture, the derivative that moves from `first` to `last` texels.
Path path(std::string_view name, std::string_view description, const reference::Gradients<double>& texels,
          float Lookup::*derivative, double first, double last) {
  const double size = test_textures().front()->width();
  const auto normalized = [&](double of) { return static_cast<float>(of / size); };
  Path made{name, description, {}, derivative, normalized(last)};
  made.start.lookup = {
      0.3F, 0.6F, normalized(texels.x.u), normalized(texels.x.v), normalized(texels.y.u), normalized(texels.y.v)};
  made.start.lookup.*derivative = normalized(first);
  return made;
}

Path random_path(SplitMix64& random) {
  constexpr std::array kDerivatives{&Lookup::dsdx, &Lookup::dtdx, &Lookup::dsdy, &Lookup::dtdy};
  Path made{"random", "tame lookups, one derivative changed by up to a tenth", {}, {}, 0};
  made.start = draw_cases(case_classes().front(), 1, random.next()).front();
  made.derivative = kDerivatives[random.below(4)];
  float& moved = made.start.lookup.*made.derivative;
  moved = std::max(std::abs(moved), 1e-6F);
  made.last = moved * 1.1F;
  return made;
}

// What decides the rest.
struct Decisions {
  int probes = 0;
  Branches branches;
  bool operator==(const Decisions&) const = default;
};

Decisions decisions(std::optional<Subject> subject, const Case& of) {
  Decisions all;
  all.probes = subject ? evaluate(*subject, of).probes : exact(of).line.probes;
  if (subject && is_unit(*subject)) all.branches = branches(of);
  return all;
}

Cause cause_of(std::optional<Subject> subject, const Decisions& before, const Decisions& after) {
  const Branches& a = before.branches;
  const Branches& b = after.branches;
  if (a.x_is_longer != b.x_is_longer) return Cause::kLongerVector;
  if (subject == Subject::kUnitTable && (a.row != b.row || a.column != b.column)) return Cause::kTableCell;
  if (before.probes != after.probes) return Cause::kProbeCount;
  if (a.exponent != b.exponent) return Cause::kExponent;
  return a.mantissas != b.mantissas ? Cause::kMantissa : Cause::kOther;
}

// How far `boundary` lies outside two values of the truth, 0 where it lies between them.
double outside(double boundary, double a, double b) {
  return std::max({std::min(a, b) - boundary, boundary - std::max(a, b), 0.0});
}

// Jump::share of a formula whose count changes between two lookups.
double share_of(Subject subject, const Case& of, const Truth& left, const Truth& right, int before, int after) {
  const Facts facts = facts_of(of, left);
  const double smallest =
      outside(texture_of(of).last_level(), left.line.level.to_double(), right.line.level.to_double());
  const double level = bound(subject, Metric::kRawLevel, facts);
  if (!std::isfinite(level)) return level;
  if (smallest <= level) return smallest / level;
  if (std::abs(before - after) != 1) return std::numeric_limits<double>::infinity();
  const double wanted = left.line.wanted.to_double();
  const double distance = outside(std::max(before, after) - 0.5, wanted, right.line.wanted.to_double());
  const double radii = bound(subject, Metric::kMajor, facts) + bound(subject, Metric::kEffective, facts);
  if (!std::isfinite(radii)) return radii;
  return distance / (2 * (wanted + 1) * radii);
}

Jump make_jump(std::optional<Subject> subject, const Path& path, std::uint32_t before, const Decisions& decided_before,
               const Decisions& decided_after) {
  Jump jump;
  jump.path = path.name;
  jump.before = value(before);
  jump.after = value(before + 1);
  jump.cause = cause_of(subject, decided_before, decided_after);
  const Case left = path.at(jump.before);
  jump.at = left;
  const Case right = path.at(jump.after);
  const Truth exact_left = exact(left);
  const Truth exact_right = exact(right);
  jump.exact_level = (exact_right.level - exact_left.level).to_double();
  jump.probes_before = decided_before.probes;
  jump.probes_after = decided_after.probes;
  if (!subject) {
    jump.level = jump.exact_level;
    jump.colour = (exact_right.colour - exact_left.colour).to_double();
    return jump;
  }
  const Outcome a = evaluate(*subject, left);
  const Outcome b = evaluate(*subject, right);
  jump.level = b.level - a.level;
  jump.colour = b.colour - a.colour;
  if (!is_unit(*subject)) jump.share = share_of(*subject, left, exact_left, exact_right, a.probes, b.probes);
  // Written so that NaN is rounding, too.
  if (!is_unit(*subject) && !(jump.share <= 1)) jump.cause = Cause::kRounding;
  return jump;
}

}  // namespace

Case Path::at(float moved) const {
  Case of = start;
  of.lookup.*derivative = moved;
  return of;
}

std::vector<Path> paths(std::uint64_t random_count, std::uint64_t seed) {
  std::vector<Path> all{
      path("probe_count", "minor radius 2 texels, major 2 to 20: every count from 1 to 16", {{0, 0}, {0, 2}},
           &Lookup::dsdx, 2, 20),
      path("whole_level", "one probe, level 0.93 to 1.07", {{0, 0}, {0, 1.9}}, &Lookup::dsdx, 1.9, 2.1),
      path("one_texel", "major radius 1/2 to 3/2 texel, minor 1/2: both clamped to one texel, then one",
           {{0, 0}, {0, 0.5}}, &Lookup::dsdx, 0.5, 1.5),
      path("smallest_level", "minor radius 240 to 270 texels of 256, major 1000: the level of 1 x 1 takes one probe",
           {{1000, 0}, {0, 0}}, &Lookup::dtdy, 240, 270),
      path("angle", "the shorter gradient turns from a right angle to nearly parallel, and becomes the longer",
           {{8, 0}, {0, 3}}, &Lookup::dsdy, 0.01, 12),
      path("ratio", "the shorter gradient grows to the longer one's length", {{16, 0}, {1, 0}}, &Lookup::dtdy, 0.5, 16),
      path("longer_vector", "gradients (8, 3) and (3, 6 to 10): equal lengths at 8", {{8, 3}, {3, 0}}, &Lookup::dtdy, 6,
           10),
      path("group_exponent", "a nearly round footprint across a power of two", {{0, 0.3}, {-0.3, 3.9}}, &Lookup::dsdx,
           3.5, 4.5),
      path("singular", "gradients (8, 3) and (8, 2.9 to 3.1): parallel at 3", {{8, 3}, {8, 0}}, &Lookup::dtdy, 2.9,
           3.1),
  };
  SplitMix64 random(derived_seed(seed, 0x9a75));
  for (std::uint64_t i = 0; i < random_count; ++i) all.push_back(random_path(random));
  return all;
}

std::vector<Jump> find_jumps(std::optional<Subject> subject, const Path& path) {
  constexpr std::uint32_t kGrid = 256;
  std::vector<Jump> jumps;
  const std::function<void(std::uint32_t, const Decisions&, std::uint32_t, const Decisions&)> split =
      [&](std::uint32_t low, const Decisions& at_low, std::uint32_t high, const Decisions& at_high) {
        if (at_low == at_high) return;
        if (high == low + 1) {
          jumps.push_back(make_jump(subject, path, low, at_low, at_high));
          return;
        }
        const std::uint32_t middle = low + (high - low) / 2;
        const Decisions at_middle = decisions(subject, path.at(value(middle)));
        split(low, at_low, middle, at_middle);
        split(middle, at_middle, high, at_high);
      };
  const std::uint32_t first = bits(path.start.lookup.*path.derivative);
  const std::uint64_t length = bits(path.last) - first;
  std::uint32_t low = first;
  Decisions at_low = decisions(subject, path.at(value(low)));
  for (std::uint32_t i = 1; i <= kGrid; ++i) {
    const auto high = first + static_cast<std::uint32_t>(length * i / kGrid);
    const Decisions at_high = decisions(subject, path.at(value(high)));
    split(low, at_low, high, at_high);
    low = high;
    at_low = at_high;
  }
  return jumps;
}

}  // namespace feline::stability
