// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/variants.h"

namespace feline {

std::span<const Variant> variants_of_mantissa_7() { return variants_of_mantissa<7>(); }

}  // namespace feline
