// SPDX-License-Identifier: Apache-2.0
// A position to the texels of one axis (testbench/prove/leaves.h, AxisTexels).
`default_nettype none

module feline_leaf_axis_texels #(
  localparam int unsigned InputWidth = feline_pkg::WrapWidth + 1 + feline_pkg::SizeWidth + feline_pkg::PositionWidth,
  localparam int unsigned OutputWidth = 2*feline_pkg::TexelIndexWidth + 2 + feline_pkg::TexelFractionWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::WrapWidth-1:0]            wrap;
  logic [1-1:0]                                linear;
  logic [feline_pkg::SizeWidth-1:0]            size;
  logic signed [feline_pkg::PositionWidth-1:0] position;
  logic [2*feline_pkg::TexelIndexWidth-1:0]    index;
  logic [2-1:0]                                outside;
  logic [feline_pkg::TexelFractionWidth-1:0]   fraction;

  assign {wrap, linear, size, position} = inputs_i;
  assign outputs_o = {index, outside, fraction};

  logic [feline_pkg::WrapWidth-1:0]                                       supported;
  logic signed [feline_pkg::PositionFraction+1:0]                         wrapped;
  logic signed [feline_pkg::SizeWidth+feline_pkg::SubtexelBits+1:0]       coordinate;

  feline_supported_wrap u_supported_wrap (.wrap_i(wrap), .wrap_o(supported));
  feline_wrap u_wrap (.position_i(position), .wrap_i(supported), .wrapped_o(wrapped));
  feline_texel_coordinate u_texel_coordinate (
    .wrapped_i(wrapped), .size_i(size), .linear_i(linear), .coordinate_o(coordinate)
  );
  feline_axis_texels u_axis_texels (
    .coordinate_i(coordinate), .size_i(size), .wrap_i(supported), .linear_i(linear), .index_o(index),
    .outside_o(outside), .fraction_o(fraction)
  );
endmodule

`default_nettype wire
