// SPDX-License-Identifier: Apache-2.0
// What reaches fetch: a beat stays until it is taken; flushes come while nothing is inside; a memory response comes
// in the cycle of its request or later, and stays until it is taken; nothing unsupported in the full configuration.
`default_nettype none

module feline_rules_fetch (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 flush_i,
  input  wire logic                 address_valid_i,
  input  wire logic                 address_ready_o,
  input  wire feline_pkg::address_t address_i,
  input  wire logic                 fetch_valid_o,
  input  wire logic                 fetch_ready_i,
  input  wire logic                 memory_request_valid_o,
  input  wire logic                 memory_request_ready_i,
  input  wire logic                 memory_response_valid_i,
  input  wire logic                 memory_response_ready_o,
  output logic                      legal_o
);
  logic                 held_q;
  logic                 response_held_q;
  logic                 requested;
  logic                 outstanding_q;
  logic [1:0]           inside_q;  // fetch has two registers
  feline_pkg::address_t address_q;
  logic                 sampler_legal;

  assign requested = memory_request_valid_o && memory_request_ready_i;

  always_ff @(posedge clk_i) begin
    held_q          <= !rst_i && address_valid_i && !address_ready_o;
    response_held_q <= !rst_i && memory_response_valid_i && !memory_response_ready_o;
    address_q       <= address_i;
    if (rst_i) begin
      outstanding_q <= 1'b0;
      inside_q      <= '0;
    end else begin
      if (requested) begin
        outstanding_q <= 1'b1;
      end else if (memory_response_valid_i && memory_response_ready_o) begin
        outstanding_q <= 1'b0;
      end
      inside_q <= inside_q + 2'(address_valid_i && address_ready_o) - 2'(fetch_valid_o && fetch_ready_i);
    end
  end

  feline_rules_sampler u_sampler (.clk_i, .rst_i, .sampler_i, .legal_o(sampler_legal));

  assign legal_o = sampler_legal && (!held_q || (address_valid_i && address_i == address_q)) &&
                   (!flush_i || (!address_valid_i && inside_q == '0)) &&
                   (!memory_response_valid_i || outstanding_q || requested) &&
                   (!response_held_q || memory_response_valid_i) &&
                   (!address_valid_i || !address_i.status[feline_pkg::StatusUnsupported]);
endmodule

`default_nettype wire
