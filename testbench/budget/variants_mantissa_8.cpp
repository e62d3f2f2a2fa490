// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/variants.h"

namespace feline {

std::span<const Variant> variants_of_mantissa_8() { return variants_of_mantissa<8>(); }

}  // namespace feline
