// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "testbench/mutation/fate.h"

namespace feline::mutation {

// What became of the mutants of one file of the model's sources.
struct FileFates {
  std::string file;  // "model/plan.h"
  std::size_t sites = 0;
  // Also of each site that no leaf and no test gets to, "not run".
  std::vector<Fate> fates;
};

// Every mutant of the model's sources that its leaves and tests reach (model_source.h), tried on the leaves of `feline
// prove` against exact arithmetic and on the model's own tests. Builds them in `workshop`; what is in the cache is not
// tried again. Throws std::runtime_error when that is not possible.
std::vector<FileFates> try_model(const Workshop& workshop);

// The files that it is about, by their paths from the project's root.
std::vector<std::string> model_files(const std::filesystem::path& source);

// Of each file what its mutants may be called: "+ at model/plan.h:57.20: a - b", "+ at model/plan.h:57.20: not run".
std::map<std::string, std::set<std::string>> model_mutant_names(const std::filesystem::path& source);

}  // namespace feline::mutation
