// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace feline {

// What a machine can do. A feature that is left out is not elaborated in the RTL. A request for it falls back as said
// here and raises Status bit kUnsupported, in the model and in the RTL: a colour may then be another unit's, never
// without the flag.
struct Features {
  // Modes. What is left out falls back to the first of trilinear, bilinear, nearest, ext, simple, table that is there.
  bool nearest = true;
  bool bilinear = true;
  bool trilinear = true;
  bool ext = true;            // EXT_texture_filter_anisotropic
  bool simple_feline = true;  // Feline 3.2
  bool table_feline = true;   // Feline 3.3
  bool gaussian = true;       // Gaussian probe kernel, Feline 3.4; falls back to bilinear
  bool factors = true;        // lengthFactor, blurFactor, aliasFactor and the ceiling, Feline 3.4; falls back to exact
  // Wrap modes. mirrored_repeat falls back to repeat and clamp_to_border to clamp_to_edge, if they are there;
  // everything else to the first of repeat, clamp_to_edge, mirrored_repeat, clamp_to_border that is.
  bool repeat = true;
  bool mirrored_repeat = true;
  bool clamp_to_edge = true;
  bool clamp_to_border = true;
  // Texel formats. What is left out falls back to the widest that is there.
  bool r8 = true;
  bool rg8 = true;
  bool rgba8 = true;
  bool srgb = true;            // sRGB decoding; falls back to linear
  bool alpha = true;           // alpha other than 255; falls back to 255, texel by texel
  bool any_size = true;        // sides that are no power of two; without it the driver refuses them
  bool level_blend = true;     // two levels a probe; falls back to the finer one
  bool linear_texels = true;   // interpolation; falls back to the nearest texel
  bool nearest_texels = true;  // falls back to interpolation
  // Derivatives other than 0, each of its own: du/dx is of s along x. Falls back to 0.
  bool dudx = true;
  bool dvdx = true;
  bool dudy = true;
  bool dvdy = true;

  constexpr bool operator==(const Features&) const = default;
};

// Which words of a ROM are there, one bit each: the first word is bit 0 of the first element.
template <std::size_t kWords>
struct WordMask {
  std::array<std::uint64_t, (kWords + 63) / 64> bits = all();

  static constexpr std::array<std::uint64_t, (kWords + 63) / 64> all() {
    std::array<std::uint64_t, (kWords + 63) / 64> full{};
    full.fill(~std::uint64_t{0});
    return full;
  }
  static constexpr WordMask none() { return {{}}; }
  constexpr bool has(std::size_t word) const { return (bits[word / 64] >> (word % 64) & 1) != 0; }
  constexpr void add(std::size_t word) { bits[word / 64] |= std::uint64_t{1} << (word % 64); }
  constexpr bool operator==(const WordMask&) const = default;
};

// The one configuration. Every width of the model and of the RTL follows from it (tables/formats.h). The legal range
// stands beside each field; RTL and model are compared at both ends of all of them (tests/configurations.sh).
struct Config {
  static constexpr int kMostTableSide = 32;
  static constexpr int kMostProbes = 32;

  int mantissa_bits = 8;          // 6 .. 10: a group-scaled derivative, sign included (Feline 3.2)
  int exponent_bits = 6;          // 2 .. 6: the group exponent, without its sign; what lies beyond is unsupported
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
  int max_size_log2 = 14;         // 4 .. 15: log2 of the largest width and height
  int guard_bits = 2;             // 0 .. 15, at most 19 - max_size_log2: position bits below a sub-texel of the
                                  // largest texture
  int least_range_log2 = 0;       // 0 .. 19: clamped coordinates saturate at 2^this textures, or farther
  int channel_fraction_bits = 4;  // 2 .. 6: fraction of a texel channel, unit 1/255; sRGB decoding needs it
  int pixel_fraction_bits = 8;    // channel_fraction_bits .. 10: fraction of a result channel, unit 1/255
  int max_probes = 16;            // 1 .. 32: probes a pixel; a lookup that may and would take more is unsupported
  int max_levels = 16;            // 1 .. 16: mip levels; more than the largest texture has are as many as it has
  int tag_bits = 16;              // 1 .. 32: the requester's name of a lookup, carried through
  // Cells row * table_columns + column of the ellipse table, and rows of the weight table, that are there. A lookup
  // that needs another one is unsupported: a footprint of no size, a weight of 0.
  WordMask<std::size_t{kMostTableSide} * kMostTableSide> table_cells{};
  WordMask<std::size_t{5} * kMostProbes> weight_rows{};
  Features features{};

  constexpr bool operator==(const Config&) const = default;
};

// The fields that are numbers, with what is legal.
struct ConfigField {
  std::string_view name;
  int Config::*field;
  int least;
  int most;
};
inline constexpr std::array kConfigFields{
    ConfigField{"mantissa_bits", &Config::mantissa_bits, 6, 10},
    ConfigField{"exponent_bits", &Config::exponent_bits, 2, 6},
    ConfigField{"table_rows", &Config::table_rows, 4, Config::kMostTableSide},
    ConfigField{"table_columns", &Config::table_columns, 4, Config::kMostTableSide},
    ConfigField{"entry_bits", &Config::entry_bits, 6, 10},
    ConfigField{"subtexel_bits", &Config::subtexel_bits, 4, 10},
    ConfigField{"level_fraction_bits", &Config::level_fraction_bits, 4, 10},
    ConfigField{"weight_bits", &Config::weight_bits, 6, 10},
    ConfigField{"factor_bits", &Config::factor_bits, 4, 10},
    ConfigField{"reciprocal_bits", &Config::reciprocal_bits, 12, 18},
    ConfigField{"line_bits", &Config::line_bits, 8, 14},
    ConfigField{"size_reciprocal_bits", &Config::size_reciprocal_bits, 12, 17},
    ConfigField{"max_size_log2", &Config::max_size_log2, 4, 15},
    ConfigField{"guard_bits", &Config::guard_bits, 0, 15},
    ConfigField{"least_range_log2", &Config::least_range_log2, 0, 19},
    ConfigField{"channel_fraction_bits", &Config::channel_fraction_bits, 2, 6},
    ConfigField{"pixel_fraction_bits", &Config::pixel_fraction_bits, 2, 10},
    ConfigField{"max_probes", &Config::max_probes, 1, Config::kMostProbes},
    ConfigField{"max_levels", &Config::max_levels, 1, 16},
    ConfigField{"tag_bits", &Config::tag_bits, 1, 32}};

struct FeatureField {
  std::string_view name;
  bool Features::*field;
};
inline constexpr std::array kFeatureFields{FeatureField{"nearest", &Features::nearest},
                                           FeatureField{"bilinear", &Features::bilinear},
                                           FeatureField{"trilinear", &Features::trilinear},
                                           FeatureField{"ext", &Features::ext},
                                           FeatureField{"simple_feline", &Features::simple_feline},
                                           FeatureField{"table_feline", &Features::table_feline},
                                           FeatureField{"gaussian", &Features::gaussian},
                                           FeatureField{"factors", &Features::factors},
                                           FeatureField{"repeat", &Features::repeat},
                                           FeatureField{"mirrored_repeat", &Features::mirrored_repeat},
                                           FeatureField{"clamp_to_edge", &Features::clamp_to_edge},
                                           FeatureField{"clamp_to_border", &Features::clamp_to_border},
                                           FeatureField{"r8", &Features::r8},
                                           FeatureField{"rg8", &Features::rg8},
                                           FeatureField{"rgba8", &Features::rgba8},
                                           FeatureField{"srgb", &Features::srgb},
                                           FeatureField{"alpha", &Features::alpha},
                                           FeatureField{"any_size", &Features::any_size},
                                           FeatureField{"level_blend", &Features::level_blend},
                                           FeatureField{"linear_texels", &Features::linear_texels},
                                           FeatureField{"nearest_texels", &Features::nearest_texels},
                                           FeatureField{"dudx", &Features::dudx},
                                           FeatureField{"dvdx", &Features::dvdx},
                                           FeatureField{"dudy", &Features::dudy},
                                           FeatureField{"dvdy", &Features::dvdy}};

// What is wrong with a configuration: the name of a field and what is legal. Neither for a legal one.
struct ConfigFault {
  std::string_view field;
  std::string_view legal;  // empty: the range in kConfigFields
};
constexpr ConfigFault fault_of(const Config& config) {
  for (const ConfigField& each : kConfigFields) {
    if (config.*each.field < each.least || config.*each.field > each.most) return {each.name, {}};
  }
  const Features& f = config.features;
  if (config.table_columns % 2 != 0) return {"table_columns", "an even number"};
  if (config.pixel_fraction_bits < config.channel_fraction_bits) {
    return {"pixel_fraction_bits", "channel_fraction_bits to 10"};
  }
  if (config.max_size_log2 + config.guard_bits > 19) return {"guard_bits", "0 to 19 - max_size_log2"};
  if (!(f.nearest || f.bilinear || f.trilinear || f.ext || f.simple_feline || f.table_feline)) {
    return {"features", "at least one mode"};
  }
  if (!(f.repeat || f.mirrored_repeat || f.clamp_to_edge || f.clamp_to_border)) {
    return {"features", "at least one wrap mode"};
  }
  if (!(f.r8 || f.rg8 || f.rgba8)) return {"features", "at least one texel format"};
  if (!(f.linear_texels || f.nearest_texels)) return {"features", "linear_texels or nearest_texels"};
  return {};
}

// Does not compile for a configuration that is not legal, and says what of it is not.
template <Config kConfig>
struct LegalConfig {
  static constexpr bool faulty(std::string_view field) { return fault_of(kConfig).field == field; }
  static_assert(!faulty("mantissa_bits"), "mantissa_bits: legal is 6 to 10");
  static_assert(!faulty("exponent_bits"), "exponent_bits: legal is 2 to 6");
  static_assert(!faulty("table_rows"), "table_rows: legal is 4 to 32");
  static_assert(!faulty("table_columns"), "table_columns: legal is an even number from 4 to 32");
  static_assert(!faulty("entry_bits"), "entry_bits: legal is 6 to 10");
  static_assert(!faulty("subtexel_bits"), "subtexel_bits: legal is 4 to 10");
  static_assert(!faulty("level_fraction_bits"), "level_fraction_bits: legal is 4 to 10");
  static_assert(!faulty("weight_bits"), "weight_bits: legal is 6 to 10");
  static_assert(!faulty("factor_bits"), "factor_bits: legal is 4 to 10");
  static_assert(!faulty("reciprocal_bits"), "reciprocal_bits: legal is 12 to 18");
  static_assert(!faulty("line_bits"), "line_bits: legal is 8 to 14");
  static_assert(!faulty("size_reciprocal_bits"), "size_reciprocal_bits: legal is 12 to 17");
  static_assert(!faulty("max_size_log2"), "max_size_log2: legal is 4 to 15");
  static_assert(!faulty("guard_bits"), "guard_bits: legal is 0 to 19 - max_size_log2");
  static_assert(!faulty("least_range_log2"), "least_range_log2: legal is 0 to 19");
  static_assert(!faulty("channel_fraction_bits"), "channel_fraction_bits: legal is 2 to 6");
  static_assert(!faulty("pixel_fraction_bits"), "pixel_fraction_bits: legal is channel_fraction_bits to 10");
  static_assert(!faulty("max_probes"), "max_probes: legal is 1 to 32");
  static_assert(!faulty("max_levels"), "max_levels: legal is 1 to 16");
  static_assert(!faulty("tag_bits"), "tag_bits: legal is 1 to 32");
  static_assert(!faulty("features"),
                "features: legal is at least one mode, wrap mode, texel format and kind of texels");
};

inline constexpr Config kDefaultConfig{};

}  // namespace feline
