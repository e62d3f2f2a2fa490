// SPDX-License-Identifier: Apache-2.0
#include "tables/format.h"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>

namespace feline {

void format_overflow(const Format& format, std::int64_t raw) {
  std::fprintf(stderr, "feline: internal error: raw value %" PRId64 " does not fit format %s (%c%d.%d)\n", raw,
               format.name.text.data(), format.is_signed ? 'S' : 'U', format.integer_bits, format.fraction_bits);
  std::abort();
}

}  // namespace feline
