// SPDX-License-Identifier: Apache-2.0
// plan keeps the rules of its streams; what passes through it is not changed.
`default_nettype none

module feline_proof_plan_stream (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 valid_i,
  input  wire feline_pkg::footprint_t beat_i,
  input  wire logic                 mark_i,
  input  wire logic                 ready_i,
  output logic                      broken_o
);
  feline_pkg::footprint_t footprint;
  feline_pkg::plan_t plan;
  logic ready;
  logic valid;
  logic mark;
  logic rst;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    footprint        = beat_i;
    footprint.tag[0] = mark;
  end

  feline_plan u_plan (
    .clk_i, .rst_i(rst), .sampler_i, .footprint_valid_i(valid_i), .footprint_ready_o(ready), .footprint_i(footprint),
    .plan_valid_o(valid), .plan_ready_i(ready_i), .plan_o(plan)
  );
  localparam int unsigned Payload = feline_pkg::TagWidth - 1 + 2*feline_pkg::PositionWidth;

  feline_stream_checker #(.Width($bits(plan)), .Payload(Payload), .Depth(5)) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b1), .in_valid_i(valid_i), .in_ready_i(ready), .mark_i, .mark_o(mark),
    .in_payload_i({footprint.tag[feline_pkg::TagWidth-1:1], footprint.s, footprint.t}),
    .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(plan.tag[0]), .out_data_i(plan),
    .out_payload_i({plan.tag[feline_pkg::TagWidth-1:1], plan.s, plan.t}),
    .broken_o
  );
endmodule

`default_nettype wire
