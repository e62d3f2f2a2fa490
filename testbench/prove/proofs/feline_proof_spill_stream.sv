// SPDX-License-Identifier: Apache-2.0
// feline_spill_register keeps the rules of its streams; it takes a beat in the cycle after one in which it was taken from.
`default_nettype none

module feline_proof_spill_stream (
  input  wire logic       clk_i,
  input  wire logic       rst_i,
  input  wire logic       valid_i,
  input  wire logic [7:0] data_i,
  input  wire logic       mark_i,
  input  wire logic       ready_i,
  output logic            broken_o
);
  logic       ready;
  logic       valid;
  logic       mark;
  logic       rst;
  logic [8:0] data;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  feline_spill_register #(.Width(9)) u_spill (
    .clk_i, .rst_i(rst), .valid_i, .ready_o(ready), .data_i({data_i, mark}),
    .valid_o(valid), .ready_i, .data_o(data)
  );
  feline_stream_checker #(.Width(9), .Payload(8), .Depth(2), .Cut(1'b1)) u_checker (
    .clk_i, .rst_i(rst), .progress_i(1'b1), .in_valid_i(valid_i), .in_ready_i(ready), .mark_i, .mark_o(mark),
    .in_payload_i(data_i), .out_valid_i(valid), .out_ready_i(ready_i), .out_mark_i(data[0]), .out_data_i(data),
    .out_payload_i(data[8:1]), .broken_o
  );
endmodule

`default_nettype wire
