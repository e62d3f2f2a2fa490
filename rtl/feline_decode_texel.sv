// SPDX-License-Identifier: Apache-2.0
// A word of a memory line to the texel in it.
//
// Takes  word, the aligned 32 bits that hold the texel; column of the texel in its tile; texel format; sRGB.
// Gives  red, green, blue, alpha U8.4, unit 1/255, red lowest.
// Rounds as feline_expand_code.
// Edges  R8 gives (r, 0, 0, 1), RG8 (r, g, 0, 1); alpha is never decoded.
// Source OpenGL 4.6, table 15.1 (missing channels).
`default_nettype none

module feline_decode_texel (
  input  wire logic [31:0]                             word_i,
  input  wire logic [feline_pkg::TileLog2-1:0]         column_i,
  input  wire logic [feline_pkg::TexelFormatWidth-1:0] texel_format_i,
  input  wire logic                                    srgb_i,
  output logic [4*feline_pkg::ChannelWidth-1:0]        texel_o
);
  localparam int unsigned ChannelWidth = feline_pkg::ChannelWidth;
  localparam int unsigned CodeWidth    = ChannelWidth - feline_pkg::ChannelFraction;
  localparam logic [CodeWidth-1:0] One = {CodeWidth{1'b1}};

  // Red, green, blue, alpha, red lowest; of a missing channel what it means, of sRGB, too: 0 decodes to 0.
  logic [4*CodeWidth-1:0] code;

  always_comb begin
    unique case (texel_format_i)
      feline_pkg::TexelFormatR8:
        code = {One, {2*CodeWidth{1'b0}}, word_i[column_i*CodeWidth +: CodeWidth]};
      feline_pkg::TexelFormatRg8:
        code = {One, {CodeWidth{1'b0}}, word_i[column_i[0]*2*CodeWidth +: 2*CodeWidth]};
      default:
        code = word_i;
    endcase
  end

  for (genvar c = 0; c < 4; c++) begin : gen_channel
    if (c < 3) begin : gen_colour
      feline_expand_code u_expand (
        .code_i(code[c*CodeWidth +: CodeWidth]), .decodes_i(srgb_i),
        .channel_o(texel_o[c*ChannelWidth +: ChannelWidth])
      );
    end else begin : gen_alpha
      assign texel_o[c*ChannelWidth +: ChannelWidth] =
          {code[c*CodeWidth +: CodeWidth], feline_pkg::ChannelFraction'(0)};
    end
  end
endmodule

`default_nettype wire
