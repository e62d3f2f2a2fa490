// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>

#include "testbench/measure/contestant.h"
#include "testbench/parallel.h"
#include "testbench/thread_time.h"

namespace feline {

// Fills a rendering row by row on all processors. `pixel(index, cost)` gives the colour of a pixel and adds to cost.
template <typename PixelOf>
Rendering render_rows(const View& view, Progress* progress, PixelOf pixel) {
  Rendering rendering{{view.gbuffer.width, view.gbuffer.height, {}}, {}, {}, 0};
  rendering.picture.pixels.resize(view.gbuffer.lookups.size());
  rendering.probes.resize(view.gbuffer.lookups.size());
  // Tables that are made on first use are no pixel's time.
  if (reference::Cost ignored; !view.gbuffer.lookups.empty()) pixel(std::size_t{0}, ignored);
  std::mutex mutex;
  std::int64_t nanoseconds = 0;
  for_each_index(0, view.gbuffer.height, [&](std::int64_t row) {
    const auto width = static_cast<std::size_t>(view.gbuffer.width);
    const std::size_t first = static_cast<std::size_t>(row) * width;
    reference::Cost cost;
    const std::int64_t start = thread_nanoseconds();
    for (std::size_t i = first; i < first + width; ++i) {
      const double before = cost.probes;
      const reference::Colour colour = pixel(i, cost);
      for (std::size_t c = 0; c < 4; ++c) rendering.picture.pixels[i][c] = static_cast<float>(colour[c]);
      rendering.probes[i] = static_cast<float>(cost.probes - before);
    }
    const std::int64_t took = thread_nanoseconds() - start;
    {
      const std::scoped_lock lock(mutex);
      nanoseconds += took;
      rendering.cost += cost;
    }
    if (progress != nullptr) progress->advance(width);
  });
  rendering.nanoseconds = static_cast<double>(nanoseconds) / static_cast<double>(view.gbuffer.lookups.size());
  return rendering;
}

}  // namespace feline
