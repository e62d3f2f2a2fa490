// SPDX-License-Identifier: Apache-2.0
// How much of the major vector a line spans (testbench/prove/leaves.h, LineFraction).
`default_nettype none

module feline_leaf_line_fraction #(
  localparam int unsigned InputWidth = 3*feline_pkg::RadiusWidth,
  localparam int unsigned OutputWidth = feline_pkg::LineFractionWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::RadiusWidth-1:0]       fitted;
  logic [feline_pkg::RadiusWidth-1:0]       major;
  logic [feline_pkg::RadiusWidth-1:0]       major_radius;
  logic [feline_pkg::LineFractionWidth-1:0] line;

  assign {fitted, major, major_radius} = inputs_i;
  assign outputs_o = {line};

  feline_line_fraction u_line_fraction (
    .major_i(major), .fitted_i(fitted), .major_radius_i(major_radius), .line_o(line)
  );
endmodule

`default_nettype wire
