// SPDX-License-Identifier: Apache-2.0
// A wrapped position to the texel coordinate that addresses a level along one axis.
//
// Takes  wrapped S1.24 textures, -1 .. 2; size U15.0 texels; linear.
// Gives  coordinate S16.8 texels.
// Rounds linear: wrapped * size to 8 fraction bits, nearest, ties up, then less half a texel. nearest: down to 8
//        fraction bits. Both are one sum in front of the dropped bits.
// Edges  none: the format holds -1.5 .. 2 times the largest size.
// Source CS248A lecture 4, step 5; OpenGL 4.6, 8.14.3 (u - 1/2).
`default_nettype none

module feline_texel_coordinate (
  input  wire logic signed [feline_pkg::PositionFraction+1:0]                  wrapped_i,
  input  wire logic [feline_pkg::SizeWidth-1:0]                                size_i,
  input  wire logic                                                            linear_i,
  output logic signed [feline_pkg::SizeWidth+feline_pkg::SubtexelBits+1:0] coordinate_o
);
  localparam int unsigned ProductWidth    = feline_pkg::PositionFraction + 2 + feline_pkg::SizeWidth;
  localparam int unsigned CoordinateWidth = feline_pkg::SizeWidth + feline_pkg::SubtexelBits + 2;
  localparam int unsigned Dropped         = feline_pkg::PositionFraction - feline_pkg::SubtexelBits;
  localparam logic signed [ProductWidth-1:0] HalfUlp   = ProductWidth'(1) << (Dropped - 1);
  localparam logic signed [ProductWidth-1:0] HalfTexel = ProductWidth'(1) << (feline_pkg::PositionFraction - 1);

  logic signed [ProductWidth-1:0] product;
  logic signed [ProductWidth-1:0] offset;

  if (feline_pkg::FeatureAnySize) begin : gen_any_size
    assign product = wrapped_i * $signed({1'b0, size_i});
  end else begin : gen_power_of_two
    logic [feline_pkg::SizeShiftWidth-1:0] log2;

    feline_one_hot_log2 #(.Width(feline_pkg::SizeWidth), .Log2Width(feline_pkg::SizeShiftWidth)) u_log2 (
      .value_i(size_i), .log2_o(log2)
    );

    assign product = ProductWidth'(wrapped_i) <<< log2;
  end

  assign offset       = linear_i ? HalfUlp - HalfTexel : '0;
  assign coordinate_o = CoordinateWidth'((product + offset) >>> Dropped);
endmodule

`default_nettype wire
