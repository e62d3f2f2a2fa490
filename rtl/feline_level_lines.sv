// SPDX-License-Identifier: Apache-2.0
// The memory lines of the four texels of a level's 2 x 2 square.
//
// Takes  two columns x, two rows y U14.0; width of the level U15.0; base U25.0, its first line.
// Gives  lines of texels 00, 10, 01, 11 U25.0, the first lowest: base + (y/4) * tiles a row + x/4.
// Rounds down to the tile; tiles a row: up.
// Edges  none.
// Source A line is a 4 x 4 tile of texels, lines of a level in rows of tiles (model/memory.h).
`default_nettype none

module feline_level_lines (
  input  wire logic [2*feline_pkg::TexelIndexWidth-1:0] x_i,
  input  wire logic [2*feline_pkg::TexelIndexWidth-1:0] y_i,
  input  wire logic [feline_pkg::SizeWidth-1:0]         width_i,
  input  wire logic [feline_pkg::LineWidth-1:0]         base_i,
  output logic [4*feline_pkg::LineWidth-1:0]            line_o
);
  localparam int unsigned IndexWidth = feline_pkg::TexelIndexWidth;
  localparam int unsigned LineWidth  = feline_pkg::LineWidth;
  localparam int unsigned TileLog2   = feline_pkg::TileLog2;
  localparam int unsigned TileWidth  = IndexWidth - TileLog2;
  localparam int unsigned TilesWidth = feline_pkg::SizeWidth - TileLog2;
  localparam int unsigned TileMask   = (1 << TileLog2) - 1;

  logic [TilesWidth-1:0] tiles_a_row;

  assign tiles_a_row = TilesWidth'((width_i + feline_pkg::SizeWidth'(TileMask)) >> TileLog2);

  for (genvar row = 0; row < 2; row++) begin : gen_row
    logic [TileWidth-1:0] tile_y;
    logic [LineWidth-1:0] row_base;

    assign tile_y   = TileWidth'(y_i[row*IndexWidth +: IndexWidth] >> TileLog2);
    if (feline_pkg::FeatureAnySize) begin : gen_any_size
      assign row_base = base_i + LineWidth'(tile_y) * LineWidth'(tiles_a_row);
    end else begin : gen_power_of_two
      // Where sides are powers of two, so are tiles a row.
      localparam int unsigned Log2Width = $clog2(TilesWidth);

      logic [Log2Width-1:0] tiles_log2;

      feline_one_hot_log2 #(.Width(TilesWidth), .Log2Width(Log2Width)) u_tiles_log2 (
        .value_i(tiles_a_row), .log2_o(tiles_log2)
      );

      assign row_base = base_i + (LineWidth'(tile_y) << tiles_log2);
    end

    for (genvar column = 0; column < 2; column++) begin : gen_column
      assign line_o[(2*row + column)*LineWidth +: LineWidth] =
          row_base + LineWidth'(TileWidth'(x_i[column*IndexWidth +: IndexWidth] >> TileLog2));
    end
  end
endmodule

`default_nettype wire
