// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "testbench/mutation/mutant.h"

namespace feline::mutation {

// Lets each word of these ROMs, which cells of the module are, be anything, as input `any` says, when input `mutant`
// names one of its bits (feline_mutation_word). Of a module with that input (instrument).
void add_word_sites(nlohmann::ordered_json& module, const std::vector<Rom>& roms);

}  // namespace feline::mutation
