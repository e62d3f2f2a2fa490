// SPDX-License-Identifier: Apache-2.0
// A word of a line to the texel in it (testbench/prove/leaves.h, DecodeTexel).
`default_nettype none

module feline_leaf_decode_texel #(
  localparam int unsigned InputWidth = feline_pkg::TexelFormatWidth + 1 + feline_pkg::TileLog2 + 32,
  localparam int unsigned OutputWidth = 4*feline_pkg::ChannelWidth
) (
  input  wire logic [InputWidth-1:0] inputs_i,
  output logic [OutputWidth-1:0]     outputs_o
);
  logic [feline_pkg::TexelFormatWidth-1:0] texel_format;
  logic [1-1:0]                            srgb;
  logic [feline_pkg::TileLog2-1:0]         column;
  logic [32-1:0]                           word;
  logic [4*feline_pkg::ChannelWidth-1:0]   texel;

  assign {texel_format, srgb, column, word} = inputs_i;
  assign outputs_o = {texel};

  logic [feline_pkg::TexelFormatWidth-1:0] supported;

  feline_supported_format u_supported_format (.texel_format_i(texel_format), .texel_format_o(supported));
  feline_decode_texel u_decode_texel (
    .word_i(word), .column_i(column), .texel_format_i(supported), .srgb_i(srgb), .texel_o(texel)
  );
endmodule

`default_nettype wire
