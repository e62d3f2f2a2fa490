// SPDX-License-Identifier: Apache-2.0
// fetch, with caches of four lines, whatever the memory does: no beat lost, repeated, overtaken or changed; a request
// that is offered to the memory stays. That words are those of the lines: feline_proof_cached_words.
`default_nettype none

module feline_proof_fetch_stream (
  input  wire logic                                          clk_i,
  input  wire logic                                          rst_i,
  input  wire feline_pkg::sampler_t                          sampler_i,
  input  wire logic                                          valid_i,
  input  wire feline_pkg::address_t                          beat_i,
  input  wire logic                                          mark_i,
  input  wire logic                                          ready_i,
  input  wire logic                                          memory_ready_i,
  input  wire logic                                          memory_valid_i,
  input  wire logic [(32 << (2 * feline_pkg::TileLog2))-1:0] memory_data_i,
  output logic                                               broken_o
);
  feline_pkg::address_t             any;
  feline_pkg::address_t             address;
  feline_pkg::fetch_t               fetch;
  logic                             offered;
  logic                             ready;
  logic                             valid;
  logic                             mark;
  logic                             rst;
  logic                             stream_broken;
  logic                             memory_request_valid;
  logic [feline_pkg::LineWidth-1:0] memory_request_line;
  logic                             memory_response_ready;
  logic                             requested_q;
  logic [feline_pkg::LineWidth-1:0] line_q;
  logic                             any_mark;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));
  // The mark, too, stays with the beat that waits.
  feline_proof_source #(.Width(feline_pkg::AddressBeatWidth + 1)) u_source (
    .clk_i, .rst_i(rst), .valid_i, .data_i({beat_i, mark_i}), .valid_o(offered), .data_o({any, any_mark}), .ready_i(ready)
  );

  always_comb begin
    address        = any;
    address.tag[0] = mark;
  end

  feline_fetch #(.Lines(4)) u_fetch (
    .clk_i, .rst_i(rst), .sampler_i, .flush_i(1'b0),
    .address_valid_i(offered), .address_ready_o(ready), .address_i(address),
    .fetch_valid_o(valid), .fetch_ready_i(ready_i), .fetch_o(fetch),
    .memory_request_valid_o(memory_request_valid), .memory_request_ready_i(memory_ready_i),
    .memory_request_line_o(memory_request_line), .memory_response_valid_i(memory_valid_i),
    .memory_response_ready_o(memory_response_ready), .memory_response_data_i(memory_data_i)
  );
  localparam int unsigned Payload = feline_pkg::TagWidth - 1 + feline_pkg::StatusWidth + feline_pkg::ProbeIndexWidth + 3 +
                                    feline_pkg::WeightWidth + feline_pkg::LevelFractionWidth +
                                    4*feline_pkg::TexelFractionWidth;

  // That it does not wait for ever: feline_proof_cache_ends.
  feline_stream_checker #(
    .Width(feline_pkg::FetchBeatWidth), .Payload(Payload), .Depth(2), .Waits(1'b1)
  ) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b0), .in_valid_i(offered), .in_ready_i(ready),
    .mark_i(any_mark), .mark_o(mark),
    .in_payload_i({address.tag[feline_pkg::TagWidth-1:1], address.status, address.probe, address.first, address.last,
                   address.linear, address.weight, address.level_fraction, address.fine_fraction_x,
                   address.fine_fraction_y, address.coarse_fraction_x, address.coarse_fraction_y}),
    .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(fetch.tag[0]), .out_data_i(fetch),
    .out_payload_i({fetch.tag[feline_pkg::TagWidth-1:1], fetch.status, fetch.probe, fetch.first, fetch.last,
                    fetch.linear, fetch.weight, fetch.level_fraction, fetch.fine_fraction_x, fetch.fine_fraction_y,
                    fetch.coarse_fraction_x, fetch.coarse_fraction_y}),
    .broken_o(stream_broken)
  );

  always_ff @(posedge clk_i) begin
    requested_q <= !rst && memory_request_valid && !memory_ready_i;
    line_q      <= memory_request_line;
  end

  assign broken_o = stream_broken ||
                    (!rst && requested_q && (!memory_request_valid || memory_request_line != line_q));
endmodule

`default_nettype wire
