// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "testbench/budget/candidate.h"
#include "testbench/measure/cache.h"
#include "testbench/measure/errors.h"
#include "testbench/measure/exhibit.h"

namespace feline {

// Of a candidate on an exhibit; of a sequence the mean square is over all frames, the worst error the worst frame's.
struct Measurement {
  Candidate candidate;
  Errors gaussian;  // against each truth
  Errors box;
  double cycles = 0;       // a pixel: a probe each, of hardware that reads eight texels a cycle
  double nanoseconds = 0;  // a pixel, of the bit-accurate model: processor time of one thread, the median of the runs
  Config hardware;         // hardware_of
};

struct BudgetSurveyOptions {
  Space space = Space::kFull;
  int strata = kTruthStrata;
  std::uint64_t seed = 1;  // of the truth's samples
  int runs = 1;            // that are timed
};

// Everything of one exhibit that a search needs.
class BudgetScene {
 public:
  // References stay valid as long as this.
  BudgetScene(const ExhibitPlan& plan, const BudgetSurveyOptions& options, const Cache& cache);

  // The space, in its order. What the cache does not hold is measured on all processors and kept there, the candidates
  // of one variant at a time: a search that was stopped goes on where it was.
  std::vector<Measurement> measure_all(Progress& progress);

  // Rendered anew and compared with the truth again.
  Measurement measure(const Candidate& candidate);

 private:
  // What is measured of a candidate; the unit's least configuration follows from it.
  struct Raw {
    Errors gaussian, box;
    double nanoseconds = 0;
    VariantUse use;
  };
  Raw render(const Candidate& candidate, int runs) const;
  Measurement finish(const Candidate& candidate, const Raw& raw) const;
  SamplerState<kDefaultConfig> sampler_of(const Candidate& candidate) const;
  std::string key(const std::string& what) const;
  void prepare(Progress* progress);  // exhibit and truths
  static nlohmann::ordered_json to_json(const Raw& raw);
  static Raw raw_from_json(const nlohmann::ordered_json& json);

  const ExhibitPlan& plan_;
  BudgetSurveyOptions options_;
  const Cache& cache_;
  std::optional<Exhibit> exhibit_;
  std::vector<Truth> truths_;
};

}  // namespace feline
