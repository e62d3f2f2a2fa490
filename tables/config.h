// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace feline {

// What a machine can do. A feature that is left out is not elaborated in the RTL; a sampler state that asks for it
// falls back as said here and raises Status bit kUnsupported, in the model and in the RTL.
struct Features {
  bool ext = true;              // EXT_texture_filter_anisotropic; falls back to trilinear
  bool simple_feline = true;    // Feline 3.2; falls back to trilinear
  bool table_feline = true;     // Feline 3.3; falls back to trilinear
  bool gaussian = true;         // Gaussian probe kernel, Feline 3.4; falls back to bilinear
  bool srgb = true;             // sRGB decoding; falls back to linear
  bool mirrored_repeat = true;  // falls back to repeat
  bool clamp_to_border = true;  // falls back to clamp to edge

  constexpr bool operator==(const Features&) const = default;
};

// The one configuration. Every width of the model and of the RTL follows from it (tables/formats.h).
struct Config {
  int mantissa_bits = 8;          // a group-scaled derivative, sign included (Feline 3.2)
  int table_rows = 16;            // ellipse table: ratio of the shorter to the longer vector (Feline 3.3)
  int table_columns = 16;         // ellipse table: tangent, then cotangent + 1
  int entry_bits = 8;             // one ellipse table value
  int subtexel_bits = 8;          // fraction of a texel that weighs neighbours
  int level_fraction_bits = 8;    // fraction of the level of detail
  int weight_bits = 8;            // fraction of a probe weight
  int factor_bits = 8;            // fraction of lengthFactor, blurFactor and aliasFactor (Feline 3.4)
  int reciprocal_bits = 16;       // fraction of 1/k
  int line_bits = 12;             // fraction of (major - minor)/major, which scales the step vector
  int size_reciprocal_bits = 15;  // fraction of the normalized mantissa of 1/width and 1/height
  int guard_bits = 2;             // position bits below a sub-texel of the largest texture
  int channel_fraction_bits = 4;  // fraction of a texel channel, whose unit is 1/255; sRGB decoding needs it
  int pixel_fraction_bits = 8;    // fraction of a result channel, unit 1/255
  int max_probes = 16;            // probes a pixel
  int max_size_log2 = 14;         // largest width and height: 16384
  int tag_bits = 16;              // the requester's name of a lookup, carried through
  Features features;

  constexpr bool operator==(const Config&) const = default;
};

inline constexpr Config kDefaultConfig{};

}  // namespace feline
