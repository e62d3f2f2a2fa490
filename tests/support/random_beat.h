// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tables/beats.h"
#include "tests/support/random.h"

namespace feline {

// Any value of a field, or of its ends, or of any size.
template <typename T>
void draw(Random& random, T& field) {
  const Format format = T::kFormatOf;
  if (random.one_in(8)) {
    field = T::from_raw(random.one_in(2) ? format.max_raw() : format.min_raw());
    return;
  }
  const auto span = static_cast<std::uint64_t>(format.max_raw() - format.min_raw()) + 1;
  const auto raw = format.min_raw() + static_cast<std::int64_t>(random.bits() % span);
  field = T::from_raw(raw >> random.below(format.width()));
}

// What every stage hands on as it came.
template <typename Beat>
void draw_what_is_handed_on(Random& random, Beat& beat) {
  draw(random, beat.tag);
  draw(random, beat.status);
  if constexpr (requires { beat.probe; }) {
    draw(random, beat.probe);
    draw(random, beat.first);
    draw(random, beat.last);
    draw(random, beat.weight);
  }
}

}  // namespace feline
