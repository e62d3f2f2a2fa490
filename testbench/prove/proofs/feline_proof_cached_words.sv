// SPDX-License-Identifier: Apache-2.0
// The word that the cache gives of a needed texel is that of its line in memory, whatever came before: with four lines
// in each half, never flushed. In memory one word, of one line and of a place in it that may be any, is all ones, all
// others are zeros. As lines are compared and words moved, nothing else, what holds of that line and bit holds of all.
`default_nettype none

module feline_proof_cached_words (
  input  wire logic                                       clk_i,
  input  wire logic                                       rst_i,
  input  wire logic                                       valid_i,
  input  wire logic                                       odd_i,
  input  wire logic [2*2*feline_pkg::TexelIndexWidth-1:0] x_i,
  input  wire logic [2*2*feline_pkg::TexelIndexWidth-1:0] y_i,
  input  wire logic [8*feline_pkg::LineWidth-1:0]         line_i,
  input  wire logic [7:0]                                 needed_i,
  input  wire logic [feline_pkg::TexelFormatWidth-1:0]    texel_format_i,
  input  wire logic [2*feline_pkg::TileLog2-1:0]          place_i,
  input  wire logic                                       ready_i,
  input  wire logic                                       memory_ready_i,
  input  wire logic                                       memory_valid_i,
  output logic                                            broken_o
);
  localparam int unsigned SetWidth   = 2;
  localparam int unsigned PlaceWidth = 2 * feline_pkg::TileLog2;
  localparam int unsigned IndexWidth = feline_pkg::TexelIndexWidth;
  localparam int unsigned LineWidth  = feline_pkg::LineWidth;
  localparam int unsigned Words      = 1 << PlaceWidth;
  localparam int unsigned BeatWidth  = 1 + 8*IndexWidth + 8*LineWidth + 8;

  // Any line, as none is special.
  localparam logic [LineWidth-1:0] White = LineWidth'(25'h0155aa5);

  logic                    rst;
  logic                    offered;
  logic                    ready;
  logic                    odd;
  logic [4*IndexWidth-1:0] x;
  logic [4*IndexWidth-1:0] y;
  logic [8*LineWidth-1:0]  line;
  logic [7:0]              needed;
  logic                    words_valid;
  logic [8*32-1:0]         word;
  logic                    request_valid;
  logic [LineWidth-1:0]    request_line;
  logic                    response_ready;
  logic [32*Words-1:0]     response;
  logic [LineWidth-1:0]    asked_q;
  logic [PlaceWidth-1:0]   place_q;
  logic [feline_pkg::TexelFormatWidth-1:0] format_q;
  logic [7:0]              wrong;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));
  feline_proof_source #(.Width(BeatWidth)) u_source (
    .clk_i, .rst_i(rst), .valid_i, .data_i({odd_i, x_i, y_i, line_i, needed_i}), .valid_o(offered),
    .data_o({odd, x, y, line, needed}), .ready_i(ready)
  );

  feline_blocking_cache #(.Lines(1 << SetWidth)) u_cache (
    .clk_i, .rst_i(rst), .flush_i(1'b0), .texel_format_i(format_q),
    .texels_valid_i(offered), .texels_ready_o(ready), .odd_i(odd), .x_i(x), .y_i(y), .line_i(line),
    .needed_i(needed), .words_valid_o(words_valid), .words_ready_i(ready_i), .word_o(word),
    .memory_request_valid_o(request_valid), .memory_request_ready_i(memory_ready_i),
    .memory_request_line_o(request_line), .memory_response_valid_i(memory_valid_i),
    .memory_response_ready_o(response_ready), .memory_response_data_i(response)
  );

  always_ff @(posedge clk_i) begin
    if (rst) begin
      place_q  <= place_i;
      format_q <= texel_format_i;
    end
    if (request_valid && memory_ready_i) asked_q <= request_line;
  end

  for (genvar w = 0; w < Words; w++) begin : gen_word
    assign response[32*w +: 32] = {32{asked_q == White && place_q == PlaceWidth'(w)}};
  end

  for (genvar i = 0; i < 8; i++) begin : gen_texel
    logic [PlaceWidth-1:0] place;
    logic [SetWidth-1:0]   unused_set;

    feline_texel_place #(.SetWidth(SetWidth)) u_place (
      .x_i(x[(i / 4 * 2 + i % 2)*IndexWidth +: IndexWidth]), .y_i(y[(i / 4 * 2 + i / 2 % 2)*IndexWidth +: IndexWidth]),
      .texel_format_i(format_q), .set_o(unused_set), .word_o(place)
    );

    assign wrong[i] = needed[i] && word[32*i +: 1] != (line[i*LineWidth +: LineWidth] == White && place == place_q);
  end

  assign broken_o = !rst && words_valid && wrong != '0;
endmodule

`default_nettype wire
