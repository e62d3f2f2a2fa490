// SPDX-License-Identifier: Apache-2.0
// What is divided by the minor radius to count probes where the count is a ceiling (choose_probes of model/plan.h).
//
// Takes  major, minor U8.7, major > 0; the mode, a supported one; probe_factor U1.8, > 0.
// Gives  the dividend in units of the radius' last bit. ext: major + minor - 1, so that the quotient is
//        ceiling(major / minor). Feline: 2 * probe_factor * major - 1, its fraction bits dropped, so that the
//        quotient is ceiling(2 f major / minor) - 1, the number of multiples of minor below 2 f major.
// Rounds down; the quotient is exact.
// Edges  major = 0 gives a dividend of no use; nobody asks for its quotient.
// Source WRL 99/1, 3.4; EXT_texture_filter_anisotropic.
`default_nettype none

module feline_probe_dividend (
  input  wire logic [feline_pkg::RadiusWidth-1:0] major_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0] minor_i,
  input  wire logic [feline_pkg::ModeWidth-1:0]   mode_i,
  input  wire logic [feline_pkg::FactorWidth-1:0] probe_factor_i,
  output logic [feline_pkg::DividendWidth-1:0]    dividend_o
);
  localparam int unsigned FactorFraction = feline_pkg::FactorFraction;
  localparam int unsigned ProductWidth   = feline_pkg::DividendWidth + FactorFraction;
  localparam bit          AnyFeline      = feline_pkg::FeatureSimpleFeline || feline_pkg::FeatureTableFeline;

  logic [feline_pkg::DividendWidth-1:0] ext;

  assign ext = feline_pkg::DividendWidth'(major_i) + feline_pkg::DividendWidth'(minor_i) - feline_pkg::DividendWidth'(1);

  if (AnyFeline && feline_pkg::FeatureFactors) begin : gen_feline
    logic [ProductWidth-1:0]              product;
    logic [feline_pkg::DividendWidth-1:0] feline;

    assign product    = ProductWidth'({probe_factor_i, 1'b0}) * ProductWidth'(major_i) - ProductWidth'(1);
    assign feline     = product[FactorFraction +: feline_pkg::DividendWidth];
    assign dividend_o = feline_pkg::FeatureExt && mode_i == feline_pkg::ModeExt ? ext : feline;

    logic unused_product;
    assign unused_product = ^product[FactorFraction-1:0];
  end else begin : gen_ext
    assign dividend_o = ext;

    logic unused_inputs;
    assign unused_inputs = ^{mode_i, probe_factor_i};
  end
endmodule

`default_nettype wire
