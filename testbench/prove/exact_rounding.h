// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace feline::prove {

// The integer nearest to x >= 0, ties up, from the whole halves in it.
constexpr std::int64_t nearest(double x) { return (static_cast<std::int64_t>(2 * x) + 1) >> 1; }

}  // namespace feline::prove
