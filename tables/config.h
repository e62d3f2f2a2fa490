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

// The one configuration. Every width of the model and of the RTL follows from it (tables/formats.h). The legal range
// stands beside each field; RTL and model are compared at both ends of all of them (tests/configurations.sh).
struct Config {
  int mantissa_bits = 8;          // 6 .. 10: a group-scaled derivative, sign included (Feline 3.2)
  int table_rows = 16;            // 4 .. 32: ellipse table, ratio of the shorter to the longer vector (Feline 3.3)
  int table_columns = 16;         // 4 .. 32, even: ellipse table, tangent, then cotangent + 1
  int entry_bits = 8;             // 6 .. 10: one ellipse table value
  int subtexel_bits = 8;          // 4 .. 10: fraction of a texel that weighs neighbours
  int level_fraction_bits = 8;    // 4 .. 10: fraction of the level of detail
  int weight_bits = 8;            // 6 .. 10: fraction of a probe weight
  int factor_bits = 8;            // 4 .. 10: fraction of lengthFactor, blurFactor and aliasFactor (Feline 3.4)
  int reciprocal_bits = 16;       // 12 .. 18: fraction of 1/k
  int line_bits = 12;             // 8 .. 14: fraction of (major - minor)/major, which scales the step vector
  int size_reciprocal_bits = 15;  // 12 .. 17: fraction of the normalized mantissa of 1/width and 1/height
  int guard_bits = 2;             // 0 .. 4: position bits below a sub-texel of the largest texture
  int channel_fraction_bits = 4;  // 2 .. 6: fraction of a texel channel, unit 1/255; sRGB decoding needs it
  int pixel_fraction_bits = 8;    // channel_fraction_bits .. 10: fraction of a result channel, unit 1/255
  int max_probes = 16;            // 2 .. 32: probes a pixel
  int max_size_log2 = 14;         // 10 .. 15: log2 of the largest width and height
  int tag_bits = 16;              // 1 .. 32: the requester's name of a lookup, carried through
  Features features;

  constexpr bool operator==(const Config&) const = default;
};

// Does not compile for a configuration that is not legal, and says which field is not.
template <Config kConfig>
struct LegalConfig {
  static constexpr bool within(int value, int least, int most) { return least <= value && value <= most; }
  static_assert(within(kConfig.mantissa_bits, 6, 10), "mantissa_bits: legal is 6 to 10");
  static_assert(within(kConfig.table_rows, 4, 32), "table_rows: legal is 4 to 32");
  static_assert(within(kConfig.table_columns, 4, 32), "table_columns: legal is 4 to 32");
  static_assert(kConfig.table_columns % 2 == 0, "table_columns: legal is an even number");
  static_assert(within(kConfig.entry_bits, 6, 10), "entry_bits: legal is 6 to 10");
  static_assert(within(kConfig.subtexel_bits, 4, 10), "subtexel_bits: legal is 4 to 10");
  static_assert(within(kConfig.level_fraction_bits, 4, 10), "level_fraction_bits: legal is 4 to 10");
  static_assert(within(kConfig.weight_bits, 6, 10), "weight_bits: legal is 6 to 10");
  static_assert(within(kConfig.factor_bits, 4, 10), "factor_bits: legal is 4 to 10");
  static_assert(within(kConfig.reciprocal_bits, 12, 18), "reciprocal_bits: legal is 12 to 18");
  static_assert(within(kConfig.line_bits, 8, 14), "line_bits: legal is 8 to 14");
  static_assert(within(kConfig.size_reciprocal_bits, 12, 17), "size_reciprocal_bits: legal is 12 to 17");
  static_assert(within(kConfig.guard_bits, 0, 4), "guard_bits: legal is 0 to 4");
  static_assert(within(kConfig.channel_fraction_bits, 2, 6), "channel_fraction_bits: legal is 2 to 6");
  static_assert(within(kConfig.pixel_fraction_bits, kConfig.channel_fraction_bits, 10),
                "pixel_fraction_bits: legal is channel_fraction_bits to 10");
  static_assert(within(kConfig.max_probes, 2, 32), "max_probes: legal is 2 to 32");
  static_assert(within(kConfig.max_size_log2, 10, 15), "max_size_log2: legal is 10 to 15");
  static_assert(within(kConfig.tag_bits, 1, 32), "tag_bits: legal is 1 to 32");
};

inline constexpr Config kDefaultConfig{};

}  // namespace feline
