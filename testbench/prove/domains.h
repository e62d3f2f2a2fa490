// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "testbench/prove/leaf.h"
#include "testbench/prove/leaves.h"

namespace feline::prove {

// An enumerator as a field has it.
std::int64_t code(auto value) { return static_cast<std::int64_t>(value); }

template <typename L>
Leaf make_leaf(std::string name, std::string_view wrapper, Domain domain) {
  return {std::move(name),
          wrapper,
          std::move(domain),
          L::kInputs,
          L::kOutputs,
          lane_words<L::kInputs>(),
          lane_words<L::kOutputs>(),
          &evaluate_model<L>,
          &evaluate_exact<L>};
}

// group, footprint and plan; walk to accumulate.
void append_front_leaves(std::vector<Leaf>& leaves);
void append_back_leaves(std::vector<Leaf>& leaves);

}  // namespace feline::prove
