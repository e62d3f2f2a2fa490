// SPDX-License-Identifier: Apache-2.0
// group keeps the rules of its streams; what passes through it is not changed.
`default_nettype none

module feline_proof_group_stream (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 valid_i,
  input  wire feline_pkg::request_t   beat_i,
  input  wire logic                 mark_i,
  input  wire logic                 ready_i,
  output logic                      broken_o
);
  feline_pkg::request_t request;
  feline_pkg::group_t group;
  logic ready;
  logic valid;
  logic mark;
  logic rst;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    request        = beat_i;
    request.tag[0] = mark;
  end

  feline_group u_group (
    .clk_i, .rst_i(rst), .sampler_i, .request_valid_i(valid_i), .request_ready_o(ready), .request_i(request),
    .group_valid_o(valid), .group_ready_i(ready_i), .group_o(group)
  );
  localparam int unsigned Payload = feline_pkg::TagWidth - 1;

  feline_stream_checker #(.Width($bits(group)), .Payload(Payload), .Depth(2)) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b1), .in_valid_i(valid_i), .in_ready_i(ready), .mark_i, .mark_o(mark),
    .in_payload_i({request.tag[feline_pkg::TagWidth-1:1]}),
    .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(group.tag[0]), .out_data_i(group),
    .out_payload_i({group.tag[feline_pkg::TagWidth-1:1]}),
    .broken_o
  );
endmodule

`default_nettype wire
