// SPDX-License-Identifier: Apache-2.0
// address keeps the rules of its streams; what passes through it is not changed.
`default_nettype none

module feline_proof_address_stream (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 valid_i,
  input  wire feline_pkg::walk_t      beat_i,
  input  wire logic                 mark_i,
  input  wire logic                 ready_i,
  output logic                      broken_o
);
  feline_pkg::walk_t walk;
  feline_pkg::address_t address;
  logic ready;
  logic valid;
  logic mark;
  logic rst;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  always_comb begin
    walk        = beat_i;
    walk.tag[0] = mark;
  end

  feline_address u_address (
    .clk_i, .rst_i(rst), .sampler_i, .walk_valid_i(valid_i), .walk_ready_o(ready), .walk_i(walk),
    .address_valid_o(valid), .address_ready_i(ready_i), .address_o(address)
  );
  localparam int unsigned Payload = feline_pkg::TagWidth + feline_pkg::StatusWidth + feline_pkg::ProbeIndexWidth + 2 +
                                      feline_pkg::WeightWidth + feline_pkg::SampledLevelWidth;

  feline_stream_checker #(.Width($bits(address)), .Payload(Payload), .Depth(4)) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b1), .in_valid_i(valid_i), .in_ready_i(ready), .mark_i, .mark_o(mark),
    .in_payload_i({walk.tag[feline_pkg::TagWidth-1:1], walk.status, walk.probe, walk.first, walk.last, walk.weight, walk.linear,
                    walk.level_of_detail}),
    .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(address.tag[0]), .out_data_i(address),
    .out_payload_i({address.tag[feline_pkg::TagWidth-1:1], address.status, address.probe, address.first, address.last, address.weight,
                     address.linear, address.level, address.level_fraction}),
    .broken_o
  );
endmodule

`default_nettype wire
