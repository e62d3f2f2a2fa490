// SPDX-License-Identifier: Apache-2.0
// What reaches address: a beat stays until it is taken; no level beyond the last one, and one level alone where texels
// are not interpolated (leaf plan.sampled_level); nothing unsupported in the full configuration.
`default_nettype none

module feline_rules_address (
  input  wire logic                 clk_i,
  input  wire logic                 rst_i,
  input  wire feline_pkg::sampler_t sampler_i,
  input  wire logic                 walk_valid_i,
  input  wire logic                 walk_ready_o,
  input  wire feline_pkg::walk_t    walk_i,
  output logic                      legal_o
);
  logic              held_q;
  feline_pkg::walk_t walk_q;
  logic              sampler_legal;

  always_ff @(posedge clk_i) begin
    held_q <= !rst_i && walk_valid_i && !walk_ready_o;
    walk_q <= walk_i;
  end

  feline_rules_sampler u_sampler (.clk_i, .rst_i, .sampler_i, .legal_o(sampler_legal));

  assign legal_o = sampler_legal && (!held_q || (walk_valid_i && walk_i == walk_q)) &&
                   (!walk_valid_i || (walk_i.level_of_detail <= {sampler_i.last_level, feline_pkg::SampledLevelFraction'(0)} &&
                                      (walk_i.linear ||
                                       walk_i.level_of_detail[feline_pkg::SampledLevelFraction-1:0] == '0) &&
                                      !walk_i.status[feline_pkg::StatusUnsupported]));
endmodule

`default_nettype wire
