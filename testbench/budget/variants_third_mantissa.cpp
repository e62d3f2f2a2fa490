// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/variants.h"

namespace feline {

std::span<const Variant> variants_of_third_mantissa() { return variants_of_mantissa<2>(); }

}  // namespace feline
