// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace feline::prove {

// Gives a field of a beat or of a sampler state its raw value.
template <typename T>
void set(T& field, std::int64_t raw) {
  field = T::from_raw(raw);
}

}  // namespace feline::prove
