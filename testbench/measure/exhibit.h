// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "testbench/image.h"
#include "testbench/measure/view.h"

namespace feline {

// What the contestants are shown: a surface, and one view of it or the frames of a sequence.
struct Exhibit {
  std::unique_ptr<Surface> surface;
  std::vector<View> frames;
  mutable std::map<std::string, double> rtl_cycles;  // by sampler, as measured so far

  bool srgb() const { return surface->texture.srgb; }
  int channels() const { return bytes_per_texel(surface->texture.format); }
};

// An exhibit that is built when first needed: everything about it may already be in the cache.
struct ExhibitPlan {
  std::string name;
  std::string description;
  std::string identity;  // all that it follows from besides the program, for the cache's keys
  int width = 0;
  int height = 0;
  int frame_count = 1;
  bool perspective = true;  // its truth is projected exactly; otherwise the footprints are affine
  std::function<Exhibit()> build;
};

// A built-in scene; a sequence's frames have half the sides, so that eight of them take as long as two stills.
ExhibitPlan plan_exhibit(const Scene& scene, int width, int height);

// A user's own G-buffer and texture. Throws InputError naming the file and what is wrong with it.
ExhibitPlan plan_exhibit(const std::filesystem::path& gbuffer, const std::filesystem::path& texture,
                         const ImageOptions& image, Wrap wrap);

}  // namespace feline
