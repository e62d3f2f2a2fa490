// SPDX-License-Identifier: Apache-2.0
// The radii after clamping to one texel and shortening (clamp_radii of model/plan.h).
//
// Takes  major_radius, minor_radius U8.7 texel * 2^exponent; the mode, a supported one; length_factor U1.8, <= 1.
// Gives  major, minor U8.7; magnified: the major radius is less than a texel, or 0.
// Rounds the shortened major radius: nearest, ties up.
// Edges  magnified: both are the major radius. ext is not shortened. Otherwise major >= minor.
// Source WRL 99/1, 3.1, 3.4; EXT_texture_filter_anisotropic.
`default_nettype none

module feline_clamp_radii (
  input  wire logic [feline_pkg::RadiusWidth-1:0]          major_radius_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]          minor_radius_i,
  input  wire logic signed [feline_pkg::ExponentWidth-1:0] exponent_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]            mode_i,
  input  wire logic [feline_pkg::FactorWidth-1:0]          length_factor_i,
  output logic                                             magnified_o,
  output logic [feline_pkg::RadiusWidth-1:0]               major_o,
  output logic [feline_pkg::RadiusWidth-1:0]               minor_o
);
  localparam int unsigned RadiusWidth  = feline_pkg::RadiusWidth;
  localparam int unsigned OneWidth     = $clog2(feline_pkg::RadiusFraction + 1) + 1;
  localparam int unsigned OneLog2Width =
      (feline_pkg::ExponentWidth > OneWidth ? feline_pkg::ExponentWidth : OneWidth) + 1;
  localparam bit          AnyFeline    = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;

  // One texel in units of the radius' last bit, 2^one_log2; 0 when it is less than that or more than any radius.
  logic [OneLog2Width-1:0] one_log2;
  logic                    below_one_bit;
  logic [RadiusWidth-1:0]  one;
  logic [RadiusWidth-1:0]  minor;
  logic [RadiusWidth-1:0]  shortened;

  assign one_log2      = OneLog2Width'(feline_pkg::RadiusFraction) - OneLog2Width'(exponent_i);
  assign below_one_bit = one_log2[OneLog2Width-1];
  assign one           = below_one_bit ? '0 : RadiusWidth'(1) << one_log2;
  assign minor         = minor_radius_i > one ? minor_radius_i : one;

  if (AnyFeline && feline_pkg::FeatureFactors) begin : gen_shortened
    localparam int unsigned FactorFraction = feline_pkg::FactorFraction;
    localparam int unsigned ProductWidth   = RadiusWidth + feline_pkg::FactorWidth;

    logic [ProductWidth-1:0] product;
    logic [RadiusWidth-1:0]  factored;

    assign product  = ProductWidth'(major_radius_i) * ProductWidth'(length_factor_i) +
                      (ProductWidth'(1) << (FactorFraction - 1));
    assign factored = product[FactorFraction +: RadiusWidth];

    always_comb begin
      shortened = factored > minor ? factored : minor;
      if (feline_pkg::FeatureExt && mode_i == feline_pkg::ModeExt) shortened = major_radius_i;
    end

    logic unused_product;
    assign unused_product = ^{product[ProductWidth-1:FactorFraction+RadiusWidth], product[FactorFraction-1:0]};
  end else begin : gen_full_length
    assign shortened = major_radius_i;

    logic unused_inputs;
    assign unused_inputs = ^{mode_i, length_factor_i};
  end

  // major < one or major = 0: no bit of the texel's place or above is set.
  assign magnified_o = below_one_bit ? major_radius_i == '0 : (major_radius_i >> one_log2) == '0;
  assign major_o     = magnified_o ? major_radius_i : shortened;
  assign minor_o     = magnified_o ? major_radius_i : minor;
endmodule

`default_nettype wire
