// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "model/reference/filters.h"
#include "testbench/gbuffer.h"
#include "testbench/measure/float_picture.h"
#include "testbench/progress.h"

namespace feline {

// What a pixel ought to be: a pixel filter, projected point by point, over the bilinear surface through the texels of
// level 0, by random samples of which every cell of a fine grid has one (stratified sampling).
//   gaussian  exp(-2 r^2), truncated at a radius of one pixel (WRL 99/1, figure 2): what EWA and Feline aim at
//   box       one pixel wide: what supersampling aims at
// The order of the filters turns with the truth, so errors are given against both.
struct Truth {
  FloatPicture gaussian;
  FloatPicture box;
  // The standard error of a channel, root mean square over the picture, estimated from two independent halves.
  double gaussian_error = 0;
  double box_error = 0;
  int samples = 0;  // of a pixel's own square; the Gaussian, pi times as large, has pi times as many
};

// A point of the surface, normalized coordinates, from a point of the picture in pixels, beyond its edges too.
using PictureProjection = std::function<reference::Vector2<double>(double x, double y)>;

// Of a surface that can be asked everywhere: samples serve all pixels around them. `strata`: cells a pixel side and
// half; 23 make 2 * 23^2 = 1058 samples a pixel.
inline constexpr int kTruthStrata = 23;
Truth compute_truth(const reference::MipMap& map, const PictureProjection& projection, int width, int height,
                    int strata, std::uint64_t seed, Progress* progress);

// Of a G-buffer, which knows each pixel's middle only: the footprint is affine, as its gradients say.
Truth compute_truth(const reference::MipMap& map, const GBuffer& gbuffer, int strata, std::uint64_t seed,
                    Progress* progress);

}  // namespace feline
