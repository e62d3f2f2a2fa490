// SPDX-License-Identifier: Apache-2.0
// The memory lines of four texels (testbench/prove/leaves.h, LevelLines).
`default_nettype none

module feline_leaf_level_lines #(
  localparam int unsigned InputWidth = 2*feline_pkg::TexelIndexWidth + 2*feline_pkg::TexelIndexWidth +
      feline_pkg::SizeWidth + feline_pkg::LineWidth,
  localparam int unsigned OutputWidth = 4*feline_pkg::LineWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [2*feline_pkg::TexelIndexWidth-1:0] x;
  logic [2*feline_pkg::TexelIndexWidth-1:0] y;
  logic [feline_pkg::SizeWidth-1:0]         width;
  logic [feline_pkg::LineWidth-1:0]         base;
  logic [4*feline_pkg::LineWidth-1:0]       line;

  assign {x, y, width, base} = inputs_i;
  assign outputs_o = {line};

  feline_level_lines u_level_lines (.x_i(x), .y_i(y), .width_i(width), .base_i(base), .line_o(line));
endmodule

`default_nettype wire
