// SPDX-License-Identifier: Apache-2.0
// accumulate gives a pixel of each last beat, in order, with its tag and status, and of no other; one that is offered
// stays; in a cycle in which its output is taken it takes a beat.
`default_nettype none

module feline_proof_accumulate_stream (
  input  wire logic                clk_i,
  input  wire logic                rst_i,
  input  wire logic                valid_i,
  input  wire feline_pkg::filter_t beat_i,
  input  wire logic                mark_i,
  input  wire logic                ready_i,
  output logic                     broken_o
);
  feline_pkg::filter_t     filter;
  feline_pkg::accumulate_t accumulate;
  logic                    ready;
  logic                    valid;
  logic                    mark;
  logic                    rst;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    filter        = beat_i;
    filter.tag[0] = mark && beat_i.last;
  end

  feline_accumulate u_accumulate (
    .clk_i, .rst_i(rst), .filter_valid_i(valid_i), .filter_ready_o(ready), .filter_i(filter),
    .accumulate_valid_o(valid), .accumulate_ready_i(ready_i), .accumulate_o(accumulate)
  );
  // Beats that are not last end inside.
  feline_stream_checker #(
    .Width($bits(accumulate)), .Payload(feline_pkg::TagWidth - 1 + feline_pkg::StatusWidth), .Depth(2)
  ) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b1), .in_valid_i(valid_i && beat_i.last), .in_ready_i(ready), .mark_i,
    .mark_o(mark), .in_payload_i({filter.tag[feline_pkg::TagWidth-1:1], filter.status}),
    .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(accumulate.tag[0]), .out_data_i(accumulate),
    .out_payload_i({accumulate.tag[feline_pkg::TagWidth-1:1], accumulate.status}), .broken_o
  );
endmodule

`default_nettype wire
