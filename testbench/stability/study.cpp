// SPDX-License-Identifier: Apache-2.0
#include "testbench/stability/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "testbench/progress.h"
#include "testbench/stability/study_data.h"

namespace feline::stability {
namespace {

constexpr std::uint64_t kRandomPaths = 40;
constexpr double kLevelStep = 1.0 / 256;
constexpr double kUnbounded = std::numeric_limits<double>::infinity();

void raise(std::optional<double>& most, const std::optional<double>& error) {
  // A lost value is all of it.
  if (error) most = std::max(most.value_or(0), std::isfinite(*error) ? *error : 1);
}

ClassResult run_class(const CaseClass& of, Study& study, Progress& progress) {
  ClassResult result;
  result.of = &of;
  for (const Case& drawn : draw_cases(of, study.options.count, study.options.seed)) {
    ++result.count;
    const Truth truth = exact(drawn);
    const Facts facts = facts_of(drawn, truth);
    Decade* decade = nullptr;
    // Only where float32 has the range and is given the gradients exactly: the plots are of the condition number.
    if (facts.condition < 1e13 && facts.ordinary_range && facts.exact_in_texels) {
      decade = &study.decades[static_cast<int>(std::log10(facts.condition))];
    }
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      const Subject subject = kSubjects[s];
      const Compared compared = compare(subject, drawn, truth, facts, evaluate(subject, drawn));
      ClassResult::Row& row = result.rows[s];
      row.other_side += compared.other_side ? 1 : 0;
      row.other_probes += compared.other_probes ? 1 : 0;
      for (std::size_t m = 0; m < kMetrics.size(); ++m) {
        if (!compared.errors[m]) continue;
        row.measures[m].add(*compared.errors[m], bound(subject, kMetrics[m], facts, study.options.tighten), drawn);
      }
      if (decade == nullptr) continue;
      raise(decade->major[s], compared.errors[static_cast<std::size_t>(Metric::kMajor)]);
      raise(decade->minor[s], compared.errors[static_cast<std::size_t>(Metric::kMinor)]);
      raise(decade->effective[s], compared.errors[static_cast<std::size_t>(Metric::kEffective)]);
    }
    progress.advance(1);
  }
  return result;
}

void add_jump(std::vector<JumpRow>& rows, const std::optional<Subject>& subject, const Jump& jump, double tighten) {
  auto row =
      std::ranges::find_if(rows, [&](const JumpRow& r) { return r.subject == subject && r.cause == jump.cause; });
  if (row == rows.end()) {
    rows.push_back({});
    row = rows.end() - 1;
    row->subject = subject;
    row->cause = jump.cause;
    row->bound = kUnbounded;
    // N to N + 1 probes: log2((N + 3/2)/(N + 1)), most from 1 to 2.
    if (!subject) row->bound = std::log2(1.25) * (1 + 1e-6);
    if (subject && is_unit(*subject)) row->bound = unit_jump_bound(*subject == Subject::kUnitTable);
    row->bound /= tighten;
  }
  ++row->places;
  const double level = std::abs(jump.level);
  const double colour = std::abs(jump.colour);
  if (level > kLevelStep || colour > 1) row->over_a_step.push_back(jump);
  if (row->places == 1 || level > row->worst_level) row->worst = jump;
  row->worst_level = std::max(row->worst_level, level);
  row->worst_colour = std::max(row->worst_colour, colour);
  row->worst_exact_level = std::max(row->worst_exact_level, std::abs(jump.exact_level));
  row->worst_probes = std::max(row->worst_probes, std::abs(jump.probes_after - jump.probes_before));
  const double share = jump.share * tighten;
  if (std::isfinite(jump.share)) {
    row->worst_share = std::max(row->worst_share, share);
  } else {
    ++row->unpromised;
  }
  const bool stable = subject && !is_unit(*subject) && !is_printed(*subject);
  row->holds = row->worst_level <= row->bound && row->worst_share <= 1 && (!stable || row->unpromised == 0);
}

void add_probe_step(std::vector<ProbeStep>& steps, const std::optional<Subject>& subject, const Jump& jump) {
  // The path's minor radius is 2 texels: 2 major/minor is the major radius.
  const double place = static_cast<double>(jump.after) * test_textures().front()->width();
  for (int probes = jump.probes_before; probes < jump.probes_after; ++probes) {
    auto step = std::ranges::find(steps, probes, &ProbeStep::probes);
    if (step == steps.end()) {
      steps.push_back({});
      step = steps.end() - 1;
      step->probes = probes;
    }
    const std::size_t s = subject ? static_cast<std::size_t>(*subject) : 0;
    (subject ? step->place[s] : step->ideal_place) = place;
    (subject ? step->level[s] : step->ideal_level) = jump.level;
  }
}

void run_jumps(Study& study, Progress& progress) {
  std::vector<std::optional<Subject>> subjects{std::nullopt};
  subjects.insert(subjects.end(), kSubjects.begin(), kSubjects.end());
  for (const Path& path : study.paths) {
    for (const auto& subject : subjects) {
      for (const Jump& jump : find_jumps(subject, path)) {
        add_jump(study.jumps, subject, jump, study.options.tighten);
        if (path.name == "probe_count") add_probe_step(study.probe_steps, subject, jump);
      }
    }
    progress.advance(study.options.count / 2);
  }
  std::ranges::stable_sort(study.jumps, {}, [](const JumpRow& row) {
    return std::pair(row.subject ? static_cast<int>(*row.subject) : -1, static_cast<int>(row.cause));
  });
  std::ranges::sort(study.probe_steps, {}, &ProbeStep::probes);
}

}  // namespace

std::vector<std::string> Study::broken() const {
  std::vector<std::string> all;
  for (const ClassResult& result : classes) {
    for (std::size_t s = 0; s < kSubjects.size(); ++s) {
      for (std::size_t m = 0; m < kMetrics.size(); ++m) {
        const Measure& measure = result.rows[s].measures[m];
        if (measure.holds()) continue;
        all.push_back(fmt::format("{}, {}: the error of {} is {:.3g} of its bound", result.of->name, kSubjectNames[s],
                                  kMetricNames[m], measure.worst_share));
      }
    }
  }
  for (const JumpRow& row : jumps) {
    if (row.holds) continue;
    all.push_back(
        fmt::format("{}, {}: a jump of {:.4g} octaves, bound {:.4g}; {:.3g} of the way that a probe count "
                    "may be from its boundary, {} places without a reason",
                    subject_name(row.subject), kCauseNames[static_cast<std::size_t>(row.cause)], row.worst_level,
                    row.bound, row.worst_share, row.unpromised));
  }
  for (const NonFiniteRow& row : non_finite) {
    for (const Subject subject : kSubjects) {
      if (row.holds(subject)) continue;
      all.push_back(fmt::format("{}, {}: a colour, level or status that the contract does not name", row.what,
                                kSubjectNames[static_cast<std::size_t>(subject)]));
    }
  }
  return all;
}

Study run_study(const StudyOptions& options) {
  Study study;
  study.options = options;
  std::vector<const CaseClass*> chosen = options.classes;
  const bool all = chosen.empty();
  if (all) {
    for (const CaseClass& of : case_classes()) chosen.push_back(&of);
    study.paths = paths(kRandomPaths, options.seed);
  }
  Progress progress("stability", chosen.size() * options.count + study.paths.size() * (options.count / 2));
  for (const CaseClass* of : chosen) study.classes.push_back(run_class(*of, study, progress));
  run_jumps(study, progress);
  if (all) study.non_finite = run_non_finite(options.seed);
  return study;
}

}  // namespace feline::stability
