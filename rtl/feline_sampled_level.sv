// SPDX-License-Identifier: Apache-2.0
// The level of detail that is sampled: biased, clamped, and in the modes of one level rounded (model/plan.h).
//
// Takes  base_level S5.8; level_bias S5.8, min_level, max_level U4.8, last_level U4.0; the mode; the magnifying filter.
// Gives  level_of_detail U4.8; linear: whether texels are interpolated; whether either is not what it should be, as the
//        configuration lacks it.
// Rounds nearest, bilinear: to the nearest level, ties to the finer one, as OpenGL and Vulkan prefer.
// Edges  Never beyond the last level in memory. Level of detail 0 magnifies.
// Source Vulkan 1.3, 16.8 (bias, clamp, magnification).
`default_nettype none

module feline_sampled_level (
  input  wire logic signed [feline_pkg::LevelOfDetailWidth-1:0] base_level_i,
  input  wire logic signed [feline_pkg::LevelOfDetailWidth-1:0] level_bias_i,
  input  wire logic [feline_pkg::SampledLevelWidth-1:0]         min_level_i,
  input  wire logic [feline_pkg::SampledLevelWidth-1:0]         max_level_i,
  input  wire logic [feline_pkg::LevelWidth-1:0]                last_level_i,
  input  wire logic                                             levels_cut_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]                 mode_i,
  input  wire logic                                             magnify_i,
  output logic [feline_pkg::SampledLevelWidth-1:0]              level_of_detail_o,
  output logic                                                  linear_o,
  output logic                                                  missing_o
);
  localparam int unsigned SampledWidth = feline_pkg::SampledLevelWidth;
  localparam int unsigned FractionBits = feline_pkg::SampledLevelFraction;
  localparam int unsigned BiasedWidth  = feline_pkg::LevelOfDetailWidth + 1;
  localparam int unsigned WideWidth    = SampledWidth + 1;
  localparam logic [WideWidth-1:0] BelowHalf = (WideWidth'(1) << (FractionBits - 1)) - WideWidth'(1);

  logic signed [BiasedWidth-1:0] biased;
  logic [SampledWidth-1:0]       lambda;
  logic                          magnifies;
  logic                          nearest_level;
  logic [WideWidth-1:0]          rounded;
  logic [WideWidth-1:0]          level;
  logic [WideWidth-1:0]          last;
  logic [SampledWidth-1:0]       sampled;
  logic                          linear;

  assign biased = BiasedWidth'(base_level_i) + BiasedWidth'(level_bias_i);

  always_comb begin
    if (biased < $signed(BiasedWidth'(min_level_i))) begin
      lambda = min_level_i;
    end else if (biased > $signed(BiasedWidth'(max_level_i))) begin
      lambda = max_level_i;
    end else begin
      lambda = biased[SampledWidth-1:0];
    end
  end

  assign magnifies     = lambda == '0;
  assign nearest_level = mode_i == feline_pkg::ModeNearest || mode_i == feline_pkg::ModeBilinear;
  assign rounded       = WideWidth'(lambda) + BelowHalf;
  assign level         = nearest_level ? {rounded[WideWidth-1:FractionBits], {FractionBits{1'b0}}} : {1'b0, lambda};
  assign last          = WideWidth'(last_level_i) << FractionBits;

  assign sampled       = level < last ? level[SampledWidth-1:0] : last[SampledWidth-1:0];
  assign linear        = magnifies ? magnify_i == feline_pkg::MagnifyLinear : mode_i != feline_pkg::ModeNearest;

  // What the configuration has of it.
  assign level_of_detail_o = feline_pkg::FeatureLevelBlend
                             ? sampled : {sampled[SampledWidth-1:FractionBits], {FractionBits{1'b0}}};
  assign linear_o  = (linear && feline_pkg::FeatureLinearTexels) || !feline_pkg::FeatureNearestTexels;
  assign missing_o = (level > last && levels_cut_i) || sampled != level_of_detail_o || linear != linear_o;

  logic unused_rounded;
  assign unused_rounded = ^rounded[FractionBits-1:0];
endmodule

`default_nettype wire
