// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/reference/mip_map.h"

namespace feline::reference {

// What a colour took. Cycles are those of hardware that reads eight texels in one (WRL 99/1, section 4).
struct Cost {
  double probes = 0;
  double texels = 0;
  double cycles = 0;
  double stamp_cycles = 0;  // of "Realistic" EWA; elsewhere as cycles

  void add(double more_probes, double more_texels, double more_cycles) {
    probes += more_probes;
    texels += more_texels;
    cycles += more_cycles;
    stamp_cycles += more_cycles;
  }
  Cost& operator+=(const Cost& other) {
    probes += other.probes;
    texels += other.texels;
    cycles += other.cycles;
    stamp_cycles += other.stamp_cycles;
    return *this;
  }
  friend Cost operator*(double factor, const Cost& cost) {
    return {factor * cost.probes, factor * cost.texels, factor * cost.cycles, factor * cost.stamp_cycles};
  }
};

// s and t are normalized coordinates; each function reads one image.

// The texel that holds the point.
Colour nearest(const Level& level, const Wrapping& wrapping, double s, double t);

// The weights of two neighbours along an axis from the fraction between them.
enum class ProbeKernel : std::uint8_t {
  kBilinear,  // 1 - f, f
  kGaussian,  // exp(-f^2) and exp(-(1-f)^2), normalized: exp(-2 d^2) at a radius of sqrt(2) texels (WRL 99/1, 3.4)
};

// The 2 x 2 texels around the point.
Colour two_by_two(const Level& level, const Wrapping& wrapping, ProbeKernel kernel, double s, double t);

// Mitchell and Netravali's family (1988) over 4 x 4 texels: Catmull-Rom is (0, 1/2), their own choice (1/3, 1/3).
struct Cubic {
  double b;
  double c;
};
inline constexpr Cubic kCatmullRom{0, 1.0 / 2};
inline constexpr Cubic kMitchell{1.0 / 3, 1.0 / 3};
double cubic_weight(const Cubic& cubic, double distance);
Colour bicubic(const Level& level, const Wrapping& wrapping, const Cubic& cubic, double s, double t);

// Two levels blended by the fraction of the level of detail (CS248A lecture 4, "Tri-linear filtering"), which is
// clamped to the levels there are. A level that weighs nothing is not read.
Colour mip_probe(const MipMap& map, ProbeKernel kernel, double level_of_detail, double s, double t, Cost& cost);

}  // namespace feline::reference
