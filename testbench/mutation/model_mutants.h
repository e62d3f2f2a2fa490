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
};

// Every mutant of the model's sources that its leaves and tests reach (model_source.h), tried on the leaves of `feline
// prove` against exact arithmetic and on the model's own tests. Builds them in `workshop`; what is in the cache is not
// tried again. Throws std::runtime_error when that is not possible.
std::vector<FileFates> try_model(const Workshop& workshop);

}  // namespace feline::mutation
