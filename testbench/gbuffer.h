// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "model/lookup.h"
#include "testbench/atomic_file.h"

namespace feline {

// What a rasteriser hands to the texture unit: one lookup a pixel.
struct GBuffer {
  int width = 0;  // pixels, 1 to kMaxImageSize
  int height = 0;
  std::vector<Lookup> lookups;  // row-major, width * height
};

// An OpenEXR file with channels s, t, dsdx, dtdx, dsdy, dtdy, named exactly so, in any order:
// normalized texture coordinates (t downwards) and their derivatives per pixel.
struct GBufferOptions {
  bool allow_non_finite = false;  // take NaN and infinity: tests of the unit's invariant 7
};

// Reads the data window; other channels are ignored; half is widened to float32 exactly.
// Throws InputError naming the file and: open, width or height (legal is 1 to kMaxImageSize),
// channels (which ones are missing), type of a channel, pixels (corrupt data), or a channel and
// its first pixel in row order that is NaN or infinite.
GBuffer read_gbuffer(const std::filesystem::path& path, const GBufferOptions& options = {});

// Float32, zip: lossless, every bit pattern; whole or not at all; the same bytes every time.
// Throws InputError when the file cannot be written, std::invalid_argument when the lookups do not
// fill the size.
void write_gbuffer(const std::filesystem::path& path, const GBuffer& gbuffer);
// The same as one of several outputs.
void write_gbuffer(OutputFiles& outputs, const std::filesystem::path& path, const GBuffer& gbuffer);

}  // namespace feline
