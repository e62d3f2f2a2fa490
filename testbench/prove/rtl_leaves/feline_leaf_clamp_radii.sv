// SPDX-License-Identifier: Apache-2.0
// The radii after clamping and shortening (testbench/prove/leaves.h, ClampRadii).
`default_nettype none

module feline_leaf_clamp_radii #(
  localparam int unsigned InputWidth = feline_pkg::ModeWidth + feline_pkg::FactorWidth + feline_pkg::ExponentWidth +
      feline_pkg::RadiusWidth + feline_pkg::RadiusWidth,
  localparam int unsigned OutputWidth = 1 + feline_pkg::RadiusWidth + feline_pkg::RadiusWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ModeWidth-1:0]            mode;
  logic [feline_pkg::FactorWidth-1:0]          length_factor;
  logic signed [feline_pkg::ExponentWidth-1:0] exponent;
  logic [feline_pkg::RadiusWidth-1:0]          major_radius;
  logic [feline_pkg::RadiusWidth-1:0]          minor_radius;
  logic [1-1:0]                                magnified;
  logic [feline_pkg::RadiusWidth-1:0]          major;
  logic [feline_pkg::RadiusWidth-1:0]          minor;

  assign {mode, length_factor, exponent, major_radius, minor_radius} = inputs_i;
  assign outputs_o = {magnified, major, minor};

  feline_clamp_radii u_clamp_radii (
    .major_radius_i(major_radius), .minor_radius_i(minor_radius), .exponent_i(exponent), .mode_i(mode),
    .length_factor_i(length_factor), .magnified_o(magnified), .major_o(major), .minor_o(minor)
  );
endmodule

`default_nettype wire
