// SPDX-License-Identifier: Apache-2.0
#include "testbench/budget/variant.h"

#include <algorithm>
#include <stdexcept>

namespace feline {

void merge(VariantUse& into, const VariantUse& from) {
  into.probes += from.probes;
  into.least_exponent = std::min(into.least_exponent, from.least_exponent);
  into.greatest_exponent = std::max(into.greatest_exponent, from.greatest_exponent);
  into.position_bits = std::max(into.position_bits, from.position_bits);
  into.wanted_probes = std::max(into.wanted_probes, from.wanted_probes);
  into.coarsest_level = std::max(into.coarsest_level, from.coarsest_level);
  into.blends |= from.blends;
  into.linear |= from.linear;
  into.nearest |= from.nearest;
  into.translucent |= from.translucent;
  into.derivatives |= from.derivatives;
}

const Variant& variant_of(const Widths& widths) {
  const Config config = config_of(widths);
  for (const auto& variants :
       {variants_of_first_mantissa(), variants_of_second_mantissa(), variants_of_third_mantissa()}) {
    const auto found = std::ranges::find(variants, config, &Variant::config);
    if (found != variants.end()) return *found;
  }
  throw std::out_of_range("no variant of these widths");
}

}  // namespace feline
