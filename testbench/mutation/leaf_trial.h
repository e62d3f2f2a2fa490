// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "testbench/mutation/aiger.h"
#include "testbench/prove/leaf.h"
#include "testbench/prove/netlist.h"

namespace feline::mutation {

// Of a circuit without state with inputs inputs_i and mutant: for each code of a mutant an output that is 1 when any
// output is another one than without a mutant.
prove::Netlist difference_netlist(const Aiger& logic, std::span<const std::uint64_t> codes);

// The number of an input of the domain at which a mutant of a leaf comes out otherwise, of each mutant, or nothing.
// Looks at so many inputs of the domain, evenly spread, or at all of them.
std::vector<std::optional<std::uint64_t>> differing_inputs(const prove::Leaf& leaf, const Aiger& logic,
                                                           std::span<const std::uint64_t> codes,
                                                           std::uint64_t most_inputs);

}  // namespace feline::mutation
