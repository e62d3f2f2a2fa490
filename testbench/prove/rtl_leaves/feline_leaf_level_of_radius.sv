// SPDX-License-Identifier: Apache-2.0
// The level of detail of a radius (testbench/prove/leaves.h, LevelOfRadius).
`default_nettype none

module feline_leaf_level_of_radius #(
  localparam int unsigned InputWidth = feline_pkg::ExponentWidth + feline_pkg::RadiusWidth,
  localparam int unsigned OutputWidth = feline_pkg::LevelOfDetailWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic signed [feline_pkg::ExponentWidth-1:0] exponent;
  logic [feline_pkg::RadiusWidth-1:0]          radius;
  logic [feline_pkg::LevelOfDetailWidth-1:0]   level;

  assign {exponent, radius} = inputs_i;
  assign outputs_o = {level};

  feline_level_of_radius u_level_of_radius (.radius_i(radius), .exponent_i(exponent), .level_o(level));
endmodule

`default_nettype wire
