// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace feline {

// Every choice of a sampler state, its code and its name, once. The RTL package gets them from here.
enum class Mode : std::uint8_t { kNearest, kBilinear, kTrilinear, kExt, kSimple, kTable };
enum class Kernel : std::uint8_t { kBilinear, kGaussian };
enum class Magnify : std::uint8_t { kNearest, kLinear };
enum class Wrap : std::uint8_t { kRepeat, kMirroredRepeat, kClampToEdge, kClampToBorder };
enum class TexelFormat : std::uint8_t { kR8, kRg8, kRgba8 };
enum class ProbeRounding : std::uint8_t { kNearest, kCeiling };  // Feline 3.1 and 3.4

inline constexpr std::array<std::string_view, 6> kModeNames{"nearest", "bilinear", "trilinear",
                                                            "ext",     "simple",   "table"};
inline constexpr std::array<std::string_view, 2> kKernelNames{"bilinear", "gaussian"};
inline constexpr std::array<std::string_view, 2> kMagnifyNames{"nearest", "linear"};
inline constexpr std::array<std::string_view, 4> kWrapNames{"repeat", "mirrored_repeat", "clamp_to_edge",
                                                            "clamp_to_border"};
inline constexpr std::array<std::string_view, 3> kTexelFormatNames{"r8", "rg8", "rgba8"};
inline constexpr std::array<std::string_view, 2> kProbeRoundingNames{"nearest", "ceiling"};

// Status bits of a lookup; the colour is defined whatever they say.
enum StatusBit : std::uint8_t {
  kCoordinateNotFinite = 1,  // s or t: NaN reads as 0, infinity as the far edge (clamps) or 0 (repeats)
  kDerivativeNotFinite = 2,  // any NaN or infinity: the footprint has no bound: one probe at the coarsest level
  kUnsupported = 4,          // the lookup needs something that the configuration leaves out
  kOverflow = 8,             // a finite coordinate that a clamp saturates, or a footprint beyond the largest exponent
};
inline constexpr std::array<std::string_view, 4> kStatusNames{"coordinate_not_finite", "derivative_not_finite",
                                                              "unsupported", "overflow"};

constexpr int bytes_per_texel(TexelFormat format) {
  return format == TexelFormat::kR8 ? 1 : format == TexelFormat::kRg8 ? 2 : 4;
}

}  // namespace feline
