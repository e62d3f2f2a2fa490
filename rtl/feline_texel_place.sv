// SPDX-License-Identifier: Apache-2.0
// Where the cache finds a texel: its set and its word.
//
// Takes  x, y U14.0 texels within the level; texel format.
// Gives  set: the low bits of the tile's row, then of its column; word: which 32 bits of the line hold the texel.
// Edges  R8 has four texels a word, RG8 two, RGBA8 one.
// Source lines are 4 x 4 tiles, row by row (model/memory.h).
`default_nettype none

module feline_texel_place #(
  parameter int unsigned SetWidth = 4
) (
  input  wire logic [feline_pkg::TexelIndexWidth-1:0]  x_i,
  input  wire logic [feline_pkg::TexelIndexWidth-1:0]  y_i,
  input  wire logic [feline_pkg::TexelFormatWidth-1:0] texel_format_i,
  output logic [SetWidth-1:0]                          set_o,
  output logic [2*feline_pkg::TileLog2-1:0]            word_o
);
  localparam int unsigned TileLog2    = feline_pkg::TileLog2;
  localparam int unsigned SlotWidth   = 2 * TileLog2;
  localparam int unsigned ColumnWidth = SetWidth / 2;
  localparam int unsigned RowWidth    = SetWidth - ColumnWidth;

  logic [SlotWidth-1:0] slot;

  assign slot  = {y_i[TileLog2-1:0], x_i[TileLog2-1:0]};
  assign set_o = {RowWidth'(y_i >> TileLog2), ColumnWidth'(x_i >> TileLog2)};

  always_comb begin
    unique case (texel_format_i)
      feline_pkg::TexelFormatR8:  word_o = slot >> 2;
      feline_pkg::TexelFormatRg8: word_o = slot >> 1;
      default:                    word_o = slot;
    endcase
  end
endmodule

`default_nettype wire
