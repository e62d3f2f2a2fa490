// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "testbench/mutation/mutant.h"

namespace feline::mutation {

// Of two flattened netlists with an instance of the same module under the same parameters, each at its path: the site
// of the other one for each site of the first, being a port of the same cell, written in the same place.
std::map<std::uint32_t, std::uint32_t> same_sites(const std::vector<Site>& sites, const std::string& path,
                                                  const std::vector<Site>& other_sites, const std::string& other_path);

}  // namespace feline::mutation
