// SPDX-License-Identifier: Apache-2.0
// How much of the major vector the probes' line spans (line_fraction of model/plan.h).
//
// Takes  major and fitted U8.7 (feline_clamp_radii, feline_fit_radius), fitted <= major <= major_radius;
//        major_radius U8.7, the vector's own.
// Gives  line U1.12: (major - fitted) / major_radius.
// Rounds down, exactly.
// Edges  major_radius 0 gives a value of no use: there is one probe then.
// Source WRL 99/1, 3.1.
`default_nettype none

module feline_line_fraction (
  input  wire logic [feline_pkg::RadiusWidth-1:0]   major_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]   fitted_i,
  input  wire logic [feline_pkg::RadiusWidth-1:0]   major_radius_i,
  output logic [feline_pkg::LineFractionWidth-1:0]  line_o
);
  localparam int unsigned RadiusWidth  = feline_pkg::RadiusWidth;
  localparam int unsigned FractionBits = feline_pkg::LineFractionFraction;

  logic [RadiusWidth-1:0] rest;

  assign rest = major_i - fitted_i;

  feline_quotient #(
    .NumeratorWidth  (RadiusWidth + FractionBits),
    .DenominatorWidth(RadiusWidth),
    .QuotientWidth   (feline_pkg::LineFractionWidth)
  ) u_quotient (
    .numerator_i  ({rest, {FractionBits{1'b0}}}),
    .denominator_i(major_radius_i),
    .quotient_o   (line_o)
  );
endmodule

`default_nettype wire
