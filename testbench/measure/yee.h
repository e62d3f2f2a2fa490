// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace feline {

// What is on a display: linear light of sRGB's primaries, 0 to 1, row-major.
struct Displayed {
  int width = 0;
  int height = 0;
  std::vector<std::array<double, 3>> pixels;
};

// How many pixels a viewer would see as different (Yee and Newman, "A Perceptual Metric for Production Testing", 2004):
// where luminance, at most 100 cd/m^2, differs by more than the threshold of vision at the local adaptation, raised by
// the contrast of each spatial frequency (Barten's sensitivity) and by masking (Daly); or where CIE L*a*b* hues do.
// OpenImageIO's compare_Yee sees no luminance at all: it reads channel 1 of a picture with one channel.
std::int64_t count_visible(const Displayed& a, const Displayed& b, double pixels_per_degree);

}  // namespace feline
