// SPDX-License-Identifier: Apache-2.0
// The cache, with four lines in each half and never flushed, does not wait for ever: for a beat, which has eight lines at
// most, it asks for none twice, and it asks, or has all words, after three cycles at most in which the memory let it go
// on. Lines are those of two levels of 16 x 16 texels. As lines are compared, nothing else, what holds of one holds of all.
`default_nettype none

module feline_proof_cache_ends (
  input  wire logic        clk_i,
  input  wire logic        rst_i,
  input  wire logic        valid_i,
  input  wire logic        odd_i,
  input  wire logic [15:0] x_i,      // two of each level
  input  wire logic [15:0] y_i,
  input  wire logic [7:0]  needed_i,
  input  wire logic        ready_i,
  input  wire logic        memory_ready_i,
  input  wire logic        memory_valid_i,
  output logic             broken_o
);
  localparam int unsigned IndexWidth = feline_pkg::TexelIndexWidth;
  localparam int unsigned LineWidth  = feline_pkg::LineWidth;
  localparam int unsigned TileLog2   = feline_pkg::TileLog2;
  localparam int unsigned SideLog2   = 4;

  // Level, row and column of its tile.
  localparam logic [LineWidth-1:0] Chosen = {(LineWidth - 5)'(0), 1'b0, 2'd1, 2'd2};

  logic                    rst;
  logic                    offered;
  logic                    ready;
  logic                    odd;
  logic [15:0]             short_x;
  logic [15:0]             short_y;
  logic [4*IndexWidth-1:0] x;
  logic [4*IndexWidth-1:0] y;
  logic [8*LineWidth-1:0]  line;
  logic [7:0]              needed;
  logic                    words_valid;
  logic                    request_valid;
  logic [LineWidth-1:0]    request_line;
  logic                    response_ready;
  logic [8*32-1:0]         unused_word;
  logic                    asked_q;   // for the line, for this beat
  logic [2:0]              cycles_q;  // since it asked
  logic                    unstalled;
  logic                    asks;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));
  feline_proof_source #(.Width(41)) u_source (
    .clk_i, .rst_i(rst), .valid_i, .data_i({odd_i, x_i, y_i, needed_i}), .valid_o(offered),
    .data_o({odd, short_x, short_y, needed}), .ready_i(ready)
  );

  for (genvar k = 0; k < 4; k++) begin : gen_index
    assign x[k*IndexWidth +: IndexWidth] = IndexWidth'(short_x[k*SideLog2 +: SideLog2]);
    assign y[k*IndexWidth +: IndexWidth] = IndexWidth'(short_y[k*SideLog2 +: SideLog2]);
  end
  for (genvar i = 0; i < 8; i++) begin : gen_line
    assign line[i*LineWidth +: LineWidth] = {
      (LineWidth - 5)'(0), 1'(i / 4),
      short_y[(i / 4 * 2 + i / 2 % 2)*SideLog2 + TileLog2 +: 2], short_x[(i / 4 * 2 + i % 2)*SideLog2 + TileLog2 +: 2]
    };
  end

  feline_blocking_cache #(.Lines(4)) u_cache (
    .clk_i, .rst_i(rst), .flush_i(1'b0), .texel_format_i(feline_pkg::TexelFormatRgba8),
    .texels_valid_i(offered), .texels_ready_o(ready), .odd_i(odd), .x_i(x), .y_i(y), .line_i(line),
    .needed_i(needed), .words_valid_o(words_valid), .words_ready_i(ready_i), .word_o(unused_word),
    .memory_request_valid_o(request_valid), .memory_request_ready_i(memory_ready_i),
    .memory_request_line_o(request_line), .memory_response_valid_i(memory_valid_i),
    .memory_response_ready_o(response_ready), .memory_response_data_i('0)
  );

  assign unstalled = (!request_valid || memory_ready_i) && (!response_ready || memory_valid_i);
  assign asks      = request_valid && memory_ready_i;

  always_ff @(posedge clk_i) begin
    asked_q  <= !rst && offered && !ready && (asked_q || (asks && request_line == Chosen));
    cycles_q <= rst || !offered || words_valid || asks ? '0 : cycles_q + 3'(unstalled);
  end

  assign broken_o = !rst && ((asked_q && request_valid && request_line == Chosen) || cycles_q == 3'd3);
endmodule

`default_nettype wire
