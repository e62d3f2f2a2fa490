// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace feline::prove {

// Gives a field of a beat or of a sampler state its raw value.
template <typename T>
void set(T& field, auto raw) {
  field = T::from_raw(static_cast<std::int64_t>(raw));
}

}  // namespace feline::prove
