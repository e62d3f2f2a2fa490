// SPDX-License-Identifier: Apache-2.0
// footprint keeps the rules of its streams; what passes through it is not changed.
`default_nettype none

module feline_proof_footprint_stream (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 valid_i,
  input  wire feline_pkg::group_t     beat_i,
  input  wire logic                 mark_i,
  input  wire logic                 ready_i,
  output logic                      broken_o
);
  feline_pkg::group_t group;
  feline_pkg::footprint_t footprint;
  logic ready;
  logic valid;
  logic mark;
  logic rst;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    group        = beat_i;
    group.tag[0] = mark;
  end

  feline_footprint u_footprint (
    .clk_i, .rst_i(rst), .sampler_i, .group_valid_i(valid_i), .group_ready_o(ready), .group_i(group),
    .footprint_valid_o(valid), .footprint_ready_i(ready_i), .footprint_o(footprint)
  );
  localparam int unsigned Payload = feline_pkg::TagWidth - 1 + 2*feline_pkg::PositionWidth + feline_pkg::ExponentWidth;

  feline_stream_checker #(.Width($bits(footprint)), .Payload(Payload), .Depth(3)) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b1), .in_valid_i(valid_i), .in_ready_i(ready), .mark_i, .mark_o(mark),
    .in_payload_i({group.tag[feline_pkg::TagWidth-1:1], group.s, group.t, group.exponent}),
    .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(footprint.tag[0]), .out_data_i(footprint),
    .out_payload_i({footprint.tag[feline_pkg::TagWidth-1:1], footprint.s, footprint.t, footprint.exponent}),
    .broken_o
  );
endmodule

`default_nettype wire
