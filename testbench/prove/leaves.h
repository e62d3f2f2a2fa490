// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "tables/formats.h"
#include "tables/unit.h"
#include "testbench/prove/lane.h"

// The arithmetic leaves that are enumerated. Each takes and gives the fields listed, raw, in the order in which its
// wrapper rtl_leaves/feline_leaf_<name>.sv packs them, first field highest. What they mean, how they are rounded and
// what happens at the edges is in the contract of the RTL modules named.
namespace feline::prove {

using UnitFormats = Formats<kUnit>;

// The format under another name.
constexpr Format named(Name name, Format format) {
  format.name = name;
  return format;
}

// feline_float_to_position.
struct Position {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("wrap", F::kWrap), named("bits", F::kFloat)};
  static constexpr std::array kOutputs{named("position", F::kPosition), named("finite", F::kFlag),
                                       named("overflow", F::kFlag), named("early", F::kFlag)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// All of feline_group but s and t, which are 0.
struct Align {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("mode", F::kMode),  named("width", F::kSize), named("height", F::kSize),
                                      named("dsdx", F::kFloat), named("dtdx", F::kFloat), named("dsdy", F::kFloat),
                                      named("dtdy", F::kFloat)};
  static constexpr std::array kOutputs{named("status", F::kStatus), named("exponent", F::kExponent),
                                       named("dudx", F::kMantissa), named("dvdx", F::kMantissa),
                                       named("dudy", F::kMantissa), named("dvdy", F::kMantissa)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// All of feline_footprint.
struct Footprint {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("mode", F::kMode), named("dudx", F::kMantissa), named("dvdx", F::kMantissa),
                                      named("dudy", F::kMantissa), named("dvdy", F::kMantissa)};
  static constexpr std::array kOutputs{named("major_u", F::kVector), named("major_v", F::kVector),
                                       named("major_radius", F::kRadius), named("minor_radius", F::kRadius)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_clamp_radii.
struct ClampRadii {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("mode", F::kMode), named("length_factor", F::kFactor),
                                      named("exponent", F::kExponent), named("major_radius", F::kRadius),
                                      named("minor_radius", F::kRadius)};
  static constexpr std::array kOutputs{named("magnified", F::kFlag), named("major", F::kRadius),
                                       named("minor", F::kRadius)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_probe_dividend and feline_wanted_probes; major >= minor, major > 0, probe_factor > 0.
struct WantedProbes {
  using F = UnitFormats;
  static constexpr Format kEighths{"eighths", false, F::kSet.eighths_width, 0, "1/8"};
  static constexpr Format kWanted{"wanted", false, bits_for(kUnit.max_probes + 2), 0, "probe"};
  static constexpr std::array kInputs{named("mode", F::kMode), named("probe_rounding", F::kFlag),
                                      named("probe_factor", F::kFactor), named("major", F::kRadius),
                                      named("minor", F::kRadius)};
  static constexpr std::array kOutputs{kWanted, kEighths};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_choose_probes in mode ext, whose radii are made so that `wanted` comes out of them: minor 2^9, major wanted *
// 2^9.
struct ChooseProbes {
  using F = UnitFormats;
  static constexpr int kMinorLog2 = 9;
  static constexpr std::array kInputs{named("magnified", F::kFlag), named("max_probes", F::kProbeCount),
                                      WantedProbes::kWanted};
  static constexpr std::array kOutputs{named("probes", F::kProbeCount), named("limited", F::kFlag)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_fit_radius; major >= minor > 0, and probes and limited as feline_choose_probes makes them of both.
struct FitRadius {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("mode", F::kMode),          named("probe_rounding", F::kFlag),
                                      named("blur_factor", F::kFactor), named("inverse_alias", F::kFactor),
                                      named("limited", F::kFlag),       named("probes", F::kProbeCount),
                                      named("major", F::kRadius),       named("minor", F::kRadius)};
  static constexpr std::array kOutputs{named("fitted", F::kRadius)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_level_of_radius.
struct LevelOfRadius {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("exponent", F::kExponent), named("radius", F::kRadius)};
  static constexpr std::array kOutputs{named("level", F::kLevelOfDetail)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_sampled_level.
struct SampledLevel {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("mode", F::kMode),
                                      named("magnify", F::kFlag),
                                      named("levels_cut", F::kFlag),
                                      named("last_level", F::kLevel),
                                      named("min_level", F::kSampledLevel),
                                      named("max_level", F::kSampledLevel),
                                      named("level_bias", F::kLevelOfDetail),
                                      named("base_level", F::kLevelOfDetail)};
  static constexpr std::array kOutputs{named("level_of_detail", F::kSampledLevel), named("linear", F::kFlag),
                                       named("missing", F::kFlag)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_line_fraction: fitted <= major <= major_radius, major_radius > 0.
struct LineFraction {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("fitted", F::kRadius), named("major", F::kRadius),
                                      named("major_radius", F::kRadius)};
  static constexpr std::array kOutputs{named("line", F::kLineFraction)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_half_step_factor; the mode is ext, or one with one probe, or Feline.
struct HalfStepFactor {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("mode", F::kMode), named("probes", F::kProbeCount),
                                      named("line", F::kLineFraction)};
  static constexpr std::array kOutputs{named("factor", F::kReciprocal)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_texture_product.
struct TextureProduct {
  using F = UnitFormats;
  static constexpr Format kProduct{"product", true, F::kVector.width() + F::kSizeReciprocal.width() - 1, 0,
                                   "2^-size_shift texture"};
  static constexpr std::array kInputs{named("reciprocal", F::kSizeReciprocal), named("vector", F::kVector)};
  static constexpr std::array kOutputs{kProduct};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_half_step: product is the major vector's u or v times a size's reciprocal.
struct HalfStep {
  using F = UnitFormats;
  static constexpr std::array kInputs{TextureProduct::kProduct, named("factor", F::kReciprocal),
                                      named("size_shift", F::kSizeShift), named("exponent", F::kExponent)};
  static constexpr std::array kOutputs{named("half_step", F::kHalfStep)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_choose_weight_row; eighths >= 8.
struct WeightRow {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("mode", F::kMode), named("probes", F::kProbeCount), WantedProbes::kEighths};
  static constexpr std::array kOutputs{named("weight_row", F::kWeightRow)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_probe_weight: the signed count of half steps of probe number `probe`, and its weight; probe < probes, and a
// weight row of that many probes.
struct ProbeWeight {
  using F = UnitFormats;
  static constexpr Format kOffset{"n", true, F::kProbeCount.width(), 0, "half step"};
  static constexpr std::array kInputs{named("probes", F::kProbeCount), named("weight_row", F::kWeightRow),
                                      named("probe", F::kProbeIndex)};
  static constexpr std::array kOutputs{kOffset, named("weight", F::kWeight), named("present", F::kFlag)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_probe_position; |n| < max_probes.
struct ProbePosition {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("centre", F::kPosition), named("half_step", F::kHalfStep),
                                      ProbeWeight::kOffset};
  static constexpr std::array kOutputs{named("position", F::kPosition)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_level_size; level <= the last level + 1.
struct LevelSize {
  using F = UnitFormats;
  static constexpr Format kLevelOf{"level", false, F::kLevel.width() + 1, 0, "level"};
  static constexpr std::array kInputs{named("size", F::kSize), kLevelOf};
  static constexpr std::array kOutputs{named("level_size", F::kSize)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_wrap, feline_texel_coordinate and feline_axis_texels in a row: a position to the texels of one axis.
struct AxisTexels {
  using F = UnitFormats;
  static constexpr Format kOutside{"outside", false, 2, 0, "bits"};
  static constexpr std::array kInputs{named("wrap", F::kWrap), named("linear", F::kFlag), named("size", F::kSize),
                                      named("position", F::kPosition)};
  static constexpr std::array kOutputs{named("index_1", F::kTexelIndex), named("index_0", F::kTexelIndex), kOutside,
                                       named("fraction", F::kTexelFractionOf)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_level_lines: columns and rows to the lines of texels 00, 10, 01, 11.
struct LevelLines {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("x_1", F::kTexelIndex), named("x_0", F::kTexelIndex),
                                      named("y_1", F::kTexelIndex), named("y_0", F::kTexelIndex),
                                      named("width", F::kSize),     named("base", F::kLine)};
  static constexpr std::array kOutputs{named("line_11", F::kLine), named("line_01", F::kLine),
                                       named("line_10", F::kLine), named("line_00", F::kLine)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_decode_texel: word is the 32 bits of the line that hold the texel of `column`.
struct DecodeTexel {
  using F = UnitFormats;
  static constexpr Format kWord{"word", false, 32, 0, "bits"};
  static constexpr Format kColumn{"column", false, kTileLog2, 0, "texel"};
  static constexpr std::array kInputs{named("texel_format", F::kTexelFormat), named("srgb", F::kFlag), kColumn, kWord};
  static constexpr std::array kOutputs{named("alpha", F::kChannel), named("blue", F::kChannel),
                                       named("green", F::kChannel), named("red", F::kChannel)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// The weight of the farther texel at a fraction: feline_rom_gaussian, or the fraction itself.
struct KernelWeight {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("fraction", F::kTexelFractionOf)};
  static constexpr std::array kOutputs{named("weight", F::kTexelFractionOf)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_interpolate between two texels of a row.
struct InterpolateTexels {
  using F = UnitFormats;
  static constexpr Format kBetween{"between", false, 8, F::kChannel.fraction_bits + kUnit.subtexel_bits, "1/255"};
  static constexpr std::array kInputs{named("a", F::kChannel), named("b", F::kChannel),
                                      named("fraction", F::kTexelFractionOf)};
  static constexpr std::array kOutputs{kBetween};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// All of feline_filter, one channel.
struct FilterTexels {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("kernel", F::kFlag),
                                      named("linear", F::kFlag),
                                      named("level_fraction", F::kLevelFraction),
                                      named("fine_x", F::kTexelFractionOf),
                                      named("fine_y", F::kTexelFractionOf),
                                      named("coarse_x", F::kTexelFractionOf),
                                      named("coarse_y", F::kTexelFractionOf),
                                      named("fine_00", F::kChannel),
                                      named("fine_10", F::kChannel),
                                      named("fine_01", F::kChannel),
                                      named("fine_11", F::kChannel),
                                      named("coarse_00", F::kChannel),
                                      named("coarse_10", F::kChannel),
                                      named("coarse_01", F::kChannel),
                                      named("coarse_11", F::kChannel)};
  static constexpr std::array kOutputs{named("colour", F::kFiltered)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

// feline_accumulate of a pixel of one probe: colour times weight, rounded.
struct WeighColour {
  using F = UnitFormats;
  static constexpr std::array kInputs{named("weight", F::kWeight), named("colour", F::kFiltered)};
  static constexpr std::array kOutputs{named("pixel", F::kPixel)};
  using Inputs = Values<kInputs>;
  using Outputs = Values<kOutputs>;
  static Outputs model(const Inputs& inputs);
  static Outputs exact(const Inputs& inputs);
};

}  // namespace feline::prove
