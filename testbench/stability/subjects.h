// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "model/lookup.h"
#include "testbench/stability/line.h"
#include "testbench/stability/textures.h"
#include "testbench/stability/truth.h"

namespace feline::stability {

// One lookup on one of test_textures().
struct Case {
  Lookup lookup;
  std::size_t texture = 0;
};
inline const TestTexture& texture_of(const Case& of) { return *test_textures()[of.texture]; }

enum class Subject { kPrintedFloat32, kPrintedDouble, kStableFloat32, kStableDouble, kUnitSimple, kUnitTable };
inline constexpr std::array kSubjects{Subject::kPrintedFloat32, Subject::kPrintedDouble, Subject::kStableFloat32,
                                      Subject::kStableDouble,   Subject::kUnitSimple,    Subject::kUnitTable};
inline constexpr std::array<std::string_view, kSubjects.size()> kSubjectNames{
    "printed float32", "printed double", "stable float32", "stable double", "unit Simple", "unit Table"};

constexpr bool is_unit(Subject subject) { return subject == Subject::kUnitSimple || subject == Subject::kUnitTable; }
constexpr bool is_printed(Subject subject) {
  return subject == Subject::kPrintedFloat32 || subject == Subject::kPrintedDouble;
}
constexpr bool is_float32(Subject subject) {
  return subject == Subject::kPrintedFloat32 || subject == Subject::kStableFloat32;
}

// What a subject makes of a case; every field is exact here, whatever the subject rounds.
struct Outcome {
  double major = 0, minor = 0;    // texels
  double axis_u = 0, axis_v = 0;  // of the major axis
  double raw_level = 0;           // before the clamps
  double level = 0;               // within the texture's levels
  int probes = 0;
  double colour = 0;        // codes, 0 .. 255
  std::int64_t status = 0;  // of the unit
};

// Any floats, of which formulas make what floating point does: the formulas of WRL 99/1 as printed (printed_axes), or
// the stable ones (ellipse_axes), then the line of probes in the same type; or the unit's model in one of its modes.
Outcome evaluate(Subject subject, const Case& of);

// The same of Feline at 200 bits; finite lookups.
struct Truth {
  ExactEllipse ellipse;
  reference::Axes<Real> axes;
  Line<Real> line;
  Real level;
  Real colour;
};
Truth exact(const Case& of);
// With another probe count: the line, level and colour on the other side of a boundary.
Truth with_probes(const Truth& truth, const Case& of, int probes);

// Row and column of the ellipse table, which vector is the longer, and what group makes of a lookup: where the unit's
// Table mode takes another branch.
struct Branches {
  std::array<std::int64_t, 4> mantissas{};
  std::int64_t exponent = 0;
  std::int64_t row = 0, column = 0;
  bool x_is_longer = false;
  bool operator==(const Branches&) const = default;
};
Branches branches(const Case& of);

}  // namespace feline::stability
