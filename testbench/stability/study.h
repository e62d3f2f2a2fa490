// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "testbench/stability/cases.h"
#include "testbench/stability/errors.h"
#include "testbench/stability/jumps.h"
#include "testbench/stability/nonfinite.h"

namespace feline::stability {

struct StudyOptions {
  std::uint64_t count = 5000;  // cases a class
  std::uint64_t seed = 1;
  std::vector<const CaseClass*> classes{};  // all of them where empty
  double tighten = 1;                       // divides every bound: for tests of what happens when one is broken
};

using Measures = std::array<Measure, kMetrics.size()>;

struct ClassResult {
  const CaseClass* of = nullptr;
  std::uint64_t count = 0;
  struct Row {
    Measures measures;
    std::uint64_t other_side = 0;    // probe counts across a boundary that the bound allows
    std::uint64_t other_probes = 0;  // all probe counts other than the truth's
  };
  std::array<Row, kSubjects.size()> rows{};
};

// By decade of the condition number: worst errors of the radii, all classes together.
struct Decade {
  std::array<std::optional<double>, kSubjects.size()> major, minor, effective;
};

// Jumps of one subject, none is the truth, from one cause.
struct JumpRow {
  std::optional<Subject> subject;
  Cause cause = Cause::kOther;
  std::uint64_t places = 0;
  std::vector<Jump> over_a_step;  // by more than 1/256 octave, or a code
  double worst_level = 0, worst_colour = 0;
  int worst_probes = 0;
  double worst_exact_level = 0;  // of Feline at 200 bits over the same ulps
  Jump worst;                    // by level
  double bound = 0;              // octaves; infinite where none
  double worst_share = 0;        // of a formula, Jump::share
  std::uint64_t unpromised = 0;  // places where the share is infinite
  bool holds = true;
};

// What a probe more does on the path probe_count: place and height of the jump from n probes on.
struct ProbeStep {
  int probes = 0;
  std::optional<double> ideal_place, ideal_level;  // fProbes + 1 = 2 major/minor; octaves
  std::array<std::optional<double>, kSubjects.size()> place, level;
};

struct Study {
  StudyOptions options;
  std::vector<ClassResult> classes;
  std::map<int, Decade> decades;  // by floor(log10(condition))
  std::vector<Path> paths;
  std::vector<JumpRow> jumps;
  std::vector<ProbeStep> probe_steps;
  std::vector<NonFiniteRow> non_finite;

  // Every broken bound, in words; none where all hold.
  std::vector<std::string> broken() const;
};

// Runs on one thread. Jumps and numbers that are not finite are looked at where all classes are.
Study run_study(const StudyOptions& options);

}  // namespace feline::stability
