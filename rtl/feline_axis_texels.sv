// SPDX-License-Identifier: Apache-2.0
// A texel coordinate to the two texels beside it along one axis.
//
// Takes  coordinate S16.8 texels; size U15.0 texels; the wrap code; linear.
// Gives  two indices U14.0 within the level, whether each lay outside (clamp to border only), and the fraction U0.8
//        of the way to the second.
// Rounds down to the first texel.
// Edges  repeat: index -1 is the last, index size the first. Others: to the nearest texel of the level. nearest: the
//        fraction is 0.
// Source CS248A lecture 4, step 5; OpenGL 4.6, 8.14.2, 8.14.3.
`default_nettype none

module feline_axis_texels (
  input  wire logic signed [feline_pkg::SizeWidth+feline_pkg::SubtexelBits+1:0] coordinate_i,
  input  wire logic [feline_pkg::SizeWidth-1:0]                                 size_i,
  input  wire logic [feline_pkg::WrapWidth-1:0]                                 wrap_i,
  input  wire logic                                                             linear_i,
  output logic [2*feline_pkg::TexelIndexWidth-1:0]                              index_o,
  output logic [1:0]                                                            outside_o,
  output logic [feline_pkg::TexelFractionWidth-1:0]                             fraction_o
);
  localparam int unsigned LowWidth   = feline_pkg::SizeWidth + 2;
  localparam int unsigned IndexWidth = feline_pkg::TexelIndexWidth;

  logic signed [LowWidth-1:0] low;
  logic [IndexWidth-1:0]      end_index;

  assign low        = coordinate_i[LowWidth+feline_pkg::SubtexelBits-1:feline_pkg::SubtexelBits];
  assign fraction_o = linear_i ? coordinate_i[feline_pkg::SubtexelBits-1:0] : '0;
  assign end_index  = IndexWidth'(size_i - 1'b1);

  for (genvar i = 0; i < 2; i++) begin : gen_texel
    logic signed [LowWidth-1:0] index;
    logic                       below;
    logic                       above;

    assign index = low + LowWidth'(i);
    assign below = index < 0;
    assign above = index >= $signed(LowWidth'(size_i));

    // Past the low end a repeat comes to the last texel and a clamp to the first, past the high end the other way.
    assign index_o[i*IndexWidth +: IndexWidth] =
        !below && !above ? IndexWidth'(index) : below == (wrap_i == feline_pkg::WrapRepeat) ? end_index : '0;
    assign outside_o[i] = feline_pkg::FeatureClampToBorder && wrap_i == feline_pkg::WrapClampToBorder &&
                          (below || above);
  end
endmodule

`default_nettype wire
