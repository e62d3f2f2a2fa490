// SPDX-License-Identifier: Apache-2.0
// What reaches group: a request of any bits, which stays until it is taken.
`default_nettype none

module feline_rules_group (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 request_valid_i,
  input  wire logic                 request_ready_o,
  input  wire feline_pkg::request_t request_i,
  output logic                      legal_o
);
  logic                 held_q;
  feline_pkg::request_t request_q;
  logic                 sampler_legal;

  always_ff @(posedge clk_i) begin
    held_q <= !rst_i && request_valid_i && !request_ready_o;
    request_q <= request_i;
  end

  feline_rules_sampler u_sampler (.clk_i, .rst_i, .sampler_i, .legal_o(sampler_legal));

  assign legal_o = sampler_legal && (!held_q || (request_valid_i && request_i == request_q));
endmodule

`default_nettype wire
