// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "testbench/mutation/fate.h"

namespace feline::mutation {

// What became of the mutants of one file of the model's sources.
struct FileFates {
  std::string file;  // "model/plan.h"
  std::size_t sites = 0;
  std::vector<Fate> fates;
  // Sites that no leaf and no test gets to while the program runs: of constant expressions and of types, or untested.
  std::vector<std::string> not_run;
};

// Every mutant of the model's sources that its leaves and tests reach (model_source.h), tried on the leaves of `feline
// prove` against exact arithmetic and on the model's own tests. Builds them in `workshop`; what is in the cache is not
// tried again. Throws std::runtime_error when that is not possible.
std::vector<FileFates> try_model(const Workshop& workshop);

// The files that it is about, by their paths from the project's root.
std::vector<std::string> model_files(const std::filesystem::path& source);

}  // namespace feline::mutation
