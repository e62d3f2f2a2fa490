// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "testbench/measure/cache.h"
#include "testbench/measure/cell.h"
#include "testbench/measure/exhibit.h"

namespace feline {

// The truth of an exhibit without its pictures at full size.
struct TruthFacts {
  double gaussian_error = 0;  // standard error of a channel
  double box_error = 0;
  int samples = 0;  // a pixel
  Focus focus;      // where trilinear filtering fails most
  // PNG in base64: the whole Gaussian truth of the first frame, and the detail of both truths.
  std::string overview_png;
  std::string gaussian_png;
  std::string box_png;
};

// Where the unit's error comes from: mean squares between one picture and the next, over all frames.
struct Split {
  std::string kernel{};   // of the probes
  double feline = 0;      // Gaussian truth to Feline with the exact ellipse, double
  double table = 0;       // from there to the 16 x 16 table, double
  double arithmetic = 0;  // from there to the 8-bit unit
};

struct ExhibitResult {
  ExhibitPlan plan;
  std::optional<TruthFacts> truth;
  std::vector<Cell> cells;
  std::vector<Split> splits;
};

struct SurveyOptions {
  std::vector<ExhibitPlan> exhibits;
  std::vector<const Contestant*> contestants;
  int strata = kTruthStrata;
  std::uint64_t seed = 1;
  std::optional<double> budget;  // seconds after which nothing is begun that the cache does not hold
};

struct Survey {
  std::vector<ExhibitResult> results;
  std::size_t missing = 0;  // pieces of work that the budget did not allow
};

// Measures everything that the cache does not hold, and keeps it there as soon as it is known: a survey that was
// stopped goes on where it was.
Survey run_survey(const SurveyOptions& options, const Cache& cache);

}  // namespace feline
