// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace feline {

inline constexpr int kGlyphWidth = 5;
inline constexpr int kGlyphHeight = 9;  // 7 above the baseline, 2 below

// Rows from the top; bit 4 is the left column.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;

// A-Z, a-z, 0-9, space and . , : ; ! ? ' ( ) - + / =; anything else is a filled block.
const Glyph& glyph(char character);

}  // namespace feline
