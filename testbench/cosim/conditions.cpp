// SPDX-License-Identifier: Apache-2.0
#include "testbench/cosim/conditions.h"

#include <cmath>

namespace feline {
namespace {

StallPattern random_pattern(SplitMix64& random) {
  switch (random.below(8)) {
    case 0: return {0.05, 1};
    case 1: return {0.3, 1};
    case 2: return {0.7, 1};
    case 3: return {0.3, 4};
    case 4: return {0.02, 60};
    default: return {};
  }
}

}  // namespace

Conditions random_conditions(SplitMix64& random) {
  constexpr double kLongestLatency = 1000;
  Conditions conditions;
  // Few batches wait long, or a run would do little else.
  conditions.memory_latency = static_cast<int>(random.below(4));
  if (random.below(32) == 0) {
    conditions.memory_latency = static_cast<int>(std::lround(std::exp2(random.unit() * std::log2(kLongestLatency))));
  }
  if (random.below(3) == 0) {
    for (StallPattern& pattern : conditions.stalls) pattern = random_pattern(random);
  }
  // A memory that answers at once behind pixels that are left standing: what has waited for a line waits on with it.
  if (random.below(8) == 0) {
    conditions.memory_latency = 1;
    conditions.stalls = {};
    conditions.at(Port::kPixel) = {0.2, 40};
  }
  if (random.below(4) == 0) conditions.resets = 1.0 / (16 << random.below(8));
  return conditions;
}

}  // namespace feline
