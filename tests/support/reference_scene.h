// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "model/reference/filters.h"
#include "model/reference/vertex_based.h"
#include "tests/support/reference_images.h"
#include "tests/support/reference_sampling.h"

// All images of a texture, and pixels as a renderer would hand them to a filter.
namespace feline::reference {

// Half as wide by a Lanczos filter of radius 3 texels of the result, repeating; or half as high.
inline Level lanczos_half(const Level& fine, bool across) {
  const auto kernel = [](double d) {
    const double x = std::numbers::pi * d;
    return std::abs(d) < 3 ? 3 * std::sin(x) * std::sin(x / 3) / (x * x) : 0;
  };
  Level coarse{across ? fine.width / 2 : fine.width, across ? fine.height : fine.height / 2, {}};
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      WeightedSum sum;
      for (int k = -5; k <= 6; ++k) {
        const double w = kernel((k - 0.5) / 2);
        add_weighted(sum.colour, w, gl_texel(fine, kRepeated, across ? 2 * x + k : x, across ? y : 2 * y + k));
        sum.weight += w;
      }
      const Colour mean = sum.mean();
      Texel texel{};
      for (std::size_t c = 0; c < 4; ++c) texel[c] = static_cast<float>(mean[c]);
      coarse.texels.push_back(texel);
    }
  }
  return coarse;
}

// Of a square texture that repeats.
inline Images images_of(const Level& base) {
  Images images{{{}, kRepeated}, box_map(base, kRepeated), {0, 0, {}, kRepeated}};
  Level row_start = base;
  for (int j = 0; base.height >> j > 0; ++j) {
    if (j > 0) row_start = lanczos_half(row_start, false);
    Level image = row_start;
    for (int i = 0; base.width >> i > 0; ++i) {
      if (i > 0) image = lanczos_half(image, true);
      images.rip.levels.push_back(image);
      if (i == j) images.lanczos.levels.push_back(image);
    }
    ++images.rip.rows;
  }
  images.rip.columns = images.rip.rows;
  return images;
}

inline Pixel pixel_of(const Filter& filter, const Lookup& lookup, const Level& base) {
  return {lookup, lookup,
          filter.axis_system ? vertex_axes(*filter.axis_system, lookup.gradients, base) : Gradients<double>{}};
}

inline Colour filtered(const Filter& filter, const Images& images, const Lookup& lookup, Cost& cost) {
  return filter.run(images, pixel_of(filter, lookup, images.lanczos.base()), cost);
}

}  // namespace feline::reference
