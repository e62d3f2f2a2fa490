// SPDX-License-Identifier: Apache-2.0
// Reset at the first cycle, and whenever rst_i says so: what holds behind it holds from any state of the flip-flops.
`default_nettype none

module feline_proof_reset (
  input  wire logic clk_i,
  input  wire logic rst_i,
  output logic      rst_o
);
  logic started_q;

  initial started_q = 1'b0;

  always_ff @(posedge clk_i) started_q <= 1'b1;

  assign rst_o = rst_i || !started_q;
endmodule

`default_nettype wire
