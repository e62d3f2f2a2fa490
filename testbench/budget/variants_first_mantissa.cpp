// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/variants.h"

namespace feline {

std::span<const Variant> variants_of_first_mantissa() { return variants_of_mantissa<0>(); }

}  // namespace feline
