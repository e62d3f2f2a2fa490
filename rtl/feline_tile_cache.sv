// SPDX-License-Identifier: Apache-2.0
// One half of the texel cache: direct-mapped lines, four looked up in a cycle, one filled.
//
// Takes  of four texels each: line U25.0, the set that it maps to, and a word within the line, 32 bits; a line to fill.
// Gives  whether the line is present, and the word; a word of a line that is not present means nothing.
// Edges  flush forgets every line. A line is seen from the cycle after its fill.
// Source CS248A lecture 4, step 6 (texel cache); a line is a 4 x 4 tile of texels (model/memory.h).
`default_nettype none

module feline_tile_cache #(
  parameter int unsigned SetWidth = 4
) (
  input  wire logic                                            clk_i,
  input  wire logic                                            rst_i,
  input  wire logic                                            flush_i,
  input  wire logic [4*feline_pkg::LineWidth-1:0]              line_i,
  input  wire logic [4*SetWidth-1:0]                           set_i,
  input  wire logic [4*2*feline_pkg::TileLog2-1:0]             word_i,
  output logic [3:0]                                           present_o,
  output logic [4*32-1:0]                                      word_o,
  input  wire logic                                            fill_valid_i,
  input  wire logic [feline_pkg::LineWidth-1:0]                fill_line_i,
  input  wire logic [SetWidth-1:0]                             fill_set_i,
  input  wire logic [(32 << (2 * feline_pkg::TileLog2))-1:0]   fill_data_i
);
  localparam int unsigned LineWidth = feline_pkg::LineWidth;
  localparam int unsigned PickWidth = 2 * feline_pkg::TileLog2;
  localparam int unsigned WordWidth = 32;
  localparam int unsigned DataWidth = WordWidth << PickWidth;
  localparam int unsigned Lines     = 1 << SetWidth;

  logic [Lines-1:0]     valid_q;
  logic [LineWidth-1:0] line_q [Lines];
  logic [DataWidth-1:0] data_q [Lines];

  for (genvar i = 0; i < 4; i++) begin : gen_lookup
    logic [SetWidth-1:0]  set;
    logic [PickWidth-1:0] word;

    assign set  = set_i[i*SetWidth +: SetWidth];
    assign word = word_i[i*PickWidth +: PickWidth];
    assign present_o[i] = valid_q[set] && line_q[set] == line_i[i*LineWidth +: LineWidth];
    assign word_o[i*WordWidth +: WordWidth] = data_q[set][word*WordWidth +: WordWidth];
  end

  always_ff @(posedge clk_i) begin
    if (rst_i || flush_i) begin
      valid_q <= '0;
    end else if (fill_valid_i) begin
      valid_q[fill_set_i] <= 1'b1;
    end
    if (fill_valid_i) begin
      line_q[fill_set_i] <= fill_line_i;
      data_q[fill_set_i] <= fill_data_i;
    end
  end
endmodule

`default_nettype wire
