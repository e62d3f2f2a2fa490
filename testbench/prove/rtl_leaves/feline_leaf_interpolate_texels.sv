// SPDX-License-Identifier: Apache-2.0
// Between two texels of a row (testbench/prove/leaves.h, InterpolateTexels).
`default_nettype none

module feline_leaf_interpolate_texels #(
  localparam int unsigned InputWidth = feline_pkg::ChannelWidth + feline_pkg::ChannelWidth +
      feline_pkg::TexelFractionWidth,
  localparam int unsigned OutputWidth = (feline_pkg::ChannelWidth + feline_pkg::TexelFractionWidth)
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::ChannelWidth-1:0]                                    a;
  logic [feline_pkg::ChannelWidth-1:0]                                    b;
  logic [feline_pkg::TexelFractionWidth-1:0]                              fraction;
  logic [(feline_pkg::ChannelWidth + feline_pkg::TexelFractionWidth)-1:0] between;

  assign {a, b, fraction} = inputs_i;
  assign outputs_o = {between};

  feline_interpolate #(
    .ValueWidth(feline_pkg::ChannelWidth), .FractionWidth(feline_pkg::TexelFractionWidth)
  ) u_interpolate (
    .a_i(a), .b_i(b), .fraction_i(fraction), .value_o(between)
  );
endmodule

`default_nettype wire
