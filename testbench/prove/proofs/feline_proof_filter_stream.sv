// SPDX-License-Identifier: Apache-2.0
// filter keeps the rules of its streams; what passes through it is not changed.
`default_nettype none

module feline_proof_filter_stream (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 valid_i,
  input  wire feline_pkg::fetch_t     beat_i,
  input  wire logic                 mark_i,
  input  wire logic                 ready_i,
  output logic                      broken_o
);
  feline_pkg::fetch_t fetch;
  feline_pkg::filter_t filter;
  logic ready;
  logic valid;
  logic mark;
  logic rst;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    fetch        = beat_i;
    fetch.tag[0] = mark;
  end

  feline_filter u_filter (
    .clk_i, .rst_i(rst), .sampler_i, .fetch_valid_i(valid_i), .fetch_ready_o(ready), .fetch_i(fetch),
    .filter_valid_o(valid), .filter_ready_i(ready_i), .filter_o(filter)
  );
  localparam int unsigned Payload = feline_pkg::TagWidth - 1 + feline_pkg::StatusWidth + feline_pkg::ProbeIndexWidth + 2 +
                                      feline_pkg::WeightWidth;

  feline_stream_checker #(.Width($bits(filter)), .Payload(Payload), .Depth(3)) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b1), .in_valid_i(valid_i), .in_ready_i(ready), .mark_i, .mark_o(mark),
    .in_payload_i({fetch.tag[feline_pkg::TagWidth-1:1], fetch.status, fetch.probe, fetch.first, fetch.last, fetch.weight}),
    .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(filter.tag[0]), .out_data_i(filter),
    .out_payload_i({filter.tag[feline_pkg::TagWidth-1:1], filter.status, filter.probe, filter.first, filter.last, filter.weight}),
    .broken_o
  );
endmodule

`default_nettype wire
