// SPDX-License-Identifier: Apache-2.0
// The pipelines of both levels in address move in step: a beat's coarse part is that of its own fine part. The coarse
// level is used where the fine part's level_fraction is not 0, and else all its fields are 0.
`default_nettype none

module feline_proof_levels_in_step (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 valid_i,
  input  wire feline_pkg::walk_t    walk_i,
  input  wire logic                 ready_i,
  output logic                      broken_o
);
  feline_pkg::address_t address;
  logic                 ready;
  logic                 valid;
  logic                 rst;
  logic                 used;

  feline_proof_reset u_reset (.clk_i, .rst_i, .rst_o(rst));

  feline_address u_address (
    .clk_i, .rst_i(rst), .sampler_i, .walk_valid_i(valid_i), .walk_ready_o(ready), .walk_i,
    .address_valid_o(valid), .address_ready_i(ready_i), .address_o(address)
  );

  assign used     = address.level_fraction != '0;
  assign broken_o = !rst && valid && (address.coarse_used != used || (!used && address.coarse_line != '0));
endmodule

`default_nettype wire
