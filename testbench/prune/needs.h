// SPDX-License-Identifier: Apache-2.0
// What beats say of the unit that they need, for those who watch all beats of a lookup.
#pragma once

#include <algorithm>
#include <array>

#include "model/fetch.h"
#include "model/group.h"

namespace feline {

// Of ds/dx, dt/dx, ds/dy, dt/dy those without which group flags the lookup, bits 0 to 3: what is not 0, and where the
// footprint has no bound, du/dx and dv/dy, which then say so.
template <Config kConfig>
int needed_derivatives(const RequestBeat<kConfig>& beat) {
  const std::array parts{float_parts(beat.dsdx.raw()), float_parts(beat.dtdx.raw()), float_parts(beat.dsdy.raw()),
                         float_parts(beat.dtdy.raw())};
  int needed = std::ranges::all_of(parts, &FloatParts::finite) ? 0 : 0b1001;
  for (std::size_t i = 0; i < parts.size(); ++i) needed |= (parts[i].exponent != 0 ? 1 : 0) << i;
  return needed;
}

// Whether a texel that is read has an alpha below one. Texels of a coarse level that is not used are 0, and nobody's.
template <Config kConfig>
bool reads_translucent(const FetchBeat<kConfig>& beat) {
  const auto all_opaque = [](const auto&... texels) { return ((texels[3] == kOpaque<kConfig>)&&...); };
  return !all_opaque(beat.fine_00, beat.fine_10, beat.fine_01, beat.fine_11) ||
         (beat.level_fraction.raw() != 0 &&
          !all_opaque(beat.coarse_00, beat.coarse_10, beat.coarse_01, beat.coarse_11));
}

}  // namespace feline
