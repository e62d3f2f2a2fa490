// SPDX-License-Identifier: Apache-2.0
// The lines of eight texels to a word of each; fetches what is missing, one line at a time.
//
// Takes  fine texels 0 .. 3 and coarse texels 4 .. 7, of each level 00, 10, 01, 11: two columns x and two rows y U14.0
//        of each level, lines U25.0, which of the eight are needed; odd, the parity of the fine level.
// Gives  of each needed texel the 32 bits of its line that hold it; of the others anything.
// Edges  fine and coarse level never share a parity, so that each has a half of the cache to itself. Lines of one level
//        may share a set (a repeat comes back to the first tile): a texel's word is kept from when its line is present
//        until all eight are there, so a line may go again for the next one.
// Memory one request at a time, none for a line that is present; flush only while nothing waits here.
`default_nettype none

module feline_blocking_cache #(
  parameter int unsigned Lines = 16
) (
  input  wire logic                                          clk_i,
  input  wire logic                                          rst_i,
  input  wire logic                                          flush_i,
  input  wire logic [feline_pkg::TexelFormatWidth-1:0]       texel_format_i,
  input  wire logic                                          texels_valid_i,
  output logic                                               texels_ready_o,
  input  wire logic                                          odd_i,
  input  wire logic [2*2*feline_pkg::TexelIndexWidth-1:0]    x_i,
  input  wire logic [2*2*feline_pkg::TexelIndexWidth-1:0]    y_i,
  input  wire logic [8*feline_pkg::LineWidth-1:0]            line_i,
  input  wire logic [7:0]                                    needed_i,
  output logic                                               words_valid_o,
  input  wire logic                                          words_ready_i,
  output logic [8*32-1:0]                                    word_o,
  output logic                                               memory_request_valid_o,
  input  wire logic                                          memory_request_ready_i,
  output logic [feline_pkg::LineWidth-1:0]                   memory_request_line_o,
  input  wire logic                                          memory_response_valid_i,
  output logic                                               memory_response_ready_o,
  input  wire logic [(32 << (2 * feline_pkg::TileLog2))-1:0] memory_response_data_i
);
  localparam int unsigned IndexWidth = feline_pkg::TexelIndexWidth;
  localparam int unsigned LineWidth  = feline_pkg::LineWidth;
  localparam int unsigned SetWidth   = $clog2(Lines);
  localparam int unsigned PickWidth  = 2 * feline_pkg::TileLog2;
  localparam int unsigned WordWidth  = 32;

  localparam logic [1:0] Look    = 2'd0;  // at the lines of the texels
  localparam logic [1:0] Request = 2'd1;  // the memory's ready is awaited
  localparam logic [1:0] Respond = 2'd2;  // the memory's line is awaited

  // Where each texel is.
  logic [8*SetWidth-1:0]  set;
  logic [8*PickWidth-1:0] pick;

  for (genvar i = 0; i < 8; i++) begin : gen_place
    feline_texel_place #(.SetWidth(SetWidth)) u_place (
      .x_i(x_i[(i / 4 * 2 + i % 2)*IndexWidth +: IndexWidth]),
      .y_i(y_i[(i / 4 * 2 + i / 2 % 2)*IndexWidth +: IndexWidth]),
      .texel_format_i, .set_o(set[i*SetWidth +: SetWidth]), .word_o(pick[i*PickWidth +: PickWidth])
    );
  end

  // The halves, even and odd levels; each serves one of the two levels, fine being group 0.
  logic [7:0]             half_present;
  logic [8*WordWidth-1:0] half_word;
  logic [1:0]             half_fill;
  logic [LineWidth-1:0]   line_q;
  logic [SetWidth-1:0]    set_q;
  logic                   half_q;

  for (genvar half = 0; half < 2; half++) begin : gen_half
    logic                   coarse;
    logic [4*LineWidth-1:0] line;
    logic [4*SetWidth-1:0]  half_set;
    logic [4*PickWidth-1:0] half_pick;

    assign coarse    = odd_i != 1'(half);
    assign line      = coarse ? line_i[4*LineWidth +: 4*LineWidth] : line_i[0 +: 4*LineWidth];
    assign half_set  = coarse ? set[4*SetWidth +: 4*SetWidth] : set[0 +: 4*SetWidth];
    assign half_pick = coarse ? pick[4*PickWidth +: 4*PickWidth] : pick[0 +: 4*PickWidth];

    feline_tile_cache #(.SetWidth(SetWidth)) u_tile_cache (
      .clk_i, .rst_i, .flush_i,
      .line_i(line), .set_i(half_set), .word_i(half_pick),
      .present_o(half_present[4*half +: 4]), .word_o(half_word[4*half*WordWidth +: 4*WordWidth]),
      .fill_valid_i(half_fill[half]), .fill_line_i(line_q), .fill_set_i(set_q), .fill_data_i(memory_response_data_i)
    );
  end

  logic [7:0]             present;
  logic [8*WordWidth-1:0] read;
  logic [7:0]             kept_q;
  logic [8*WordWidth-1:0] kept_word_q;
  logic [7:0]             missing;

  assign present = odd_i ? {half_present[3:0], half_present[7:4]} : half_present;
  assign read    = odd_i ? {half_word[4*WordWidth-1:0], half_word[8*WordWidth-1:4*WordWidth]} : half_word;
  assign missing = needed_i & ~(present | kept_q);

  assign words_valid_o  = texels_valid_i && missing == '0;
  assign texels_ready_o = words_ready_i && missing == '0;

  for (genvar i = 0; i < 8; i++) begin : gen_word
    assign word_o[i*WordWidth +: WordWidth] =
        kept_q[i] ? kept_word_q[i*WordWidth +: WordWidth] : read[i*WordWidth +: WordWidth];
  end

  // What is present while another line is missing.
  logic       waits;
  logic [7:0] keep;

  assign waits = texels_valid_i && missing != '0;
  assign keep  = needed_i & present & ~kept_q & {8{waits}};

  always_ff @(posedge clk_i) begin
    if (rst_i || (texels_valid_i && texels_ready_o)) begin
      kept_q <= '0;
    end else begin
      kept_q <= kept_q | keep;
    end
    for (int i = 0; i < 8; i++) begin
      if (keep[i]) kept_word_q[i*WordWidth +: WordWidth] <= read[i*WordWidth +: WordWidth];
    end
  end

  // The first texel whose line is missing.
  logic [LineWidth-1:0] missing_line;
  logic [SetWidth-1:0]  missing_set;
  logic                 missing_coarse;

  always_comb begin
    missing_line   = '0;
    missing_set    = '0;
    missing_coarse = 1'b0;
    for (int i = 7; i >= 0; i--) begin
      if (missing[i]) begin
        missing_line   = line_i[i*LineWidth +: LineWidth];
        missing_set    = set[i*SetWidth +: SetWidth];
        missing_coarse = i >= 4;
      end
    end
  end

  logic [1:0] state_q;
  logic       filled;

  assign memory_request_valid_o  = state_q == Request;
  assign memory_request_line_o   = line_q;
  assign memory_response_ready_o = state_q == Respond;
  assign filled                  = memory_response_valid_i && memory_response_ready_o;
  assign half_fill               = {filled && half_q, filled && !half_q};

  always_ff @(posedge clk_i) begin
    if (rst_i) begin
      state_q <= Look;
    end else begin
      unique case (state_q)
        Look:    if (waits) state_q <= Request;
        Request: if (memory_request_ready_i) state_q <= Respond;
        default: if (memory_response_valid_i) state_q <= Look;
      endcase
    end
    if (state_q == Look && waits) begin
      line_q <= missing_line;
      set_q  <= missing_set;
      half_q <= odd_i ^ missing_coarse;
    end
  end
endmodule

`default_nettype wire
