// SPDX-License-Identifier: Apache-2.0
// What reaches walk: a plan stays until it is taken; 1 to MaxProbes probes; a row of weights of so many probes (test
// plan.a_row_of_weights_has_its_probe_count); nothing unsupported in the full configuration (leaves plan.choose_probes
// and plan.weight_row; proof plan_stream).
`default_nettype none

module feline_rules_walk (
  input  wire logic              clk_i,
  input  wire logic              rst_i,
  input  wire logic              plan_valid_i,
  input  wire logic              plan_ready_o,
  input  wire feline_pkg::plan_t plan_i,
  output logic                   legal_o
);
  logic              held_q;
  feline_pkg::plan_t plan_q;
  logic              is_gaussian;
  logic              is_equal;

  // Four rows a count, but one of one probe; then one a count.
  assign is_gaussian = 32'(plan_i.weight_row) + 32'd4 <= {32'(plan_i.probes), 2'b00} &&
                       32'(plan_i.weight_row) + 32'd7 >= {32'(plan_i.probes), 2'b00};
  assign is_equal    = 32'(plan_i.weight_row) + 32'd1 == 32'(plan_i.probes) + feline_pkg::GaussianRows;

  always_ff @(posedge clk_i) begin
    held_q <= !rst_i && plan_valid_i && !plan_ready_o;
    plan_q <= plan_i;
  end

  assign legal_o = (!held_q || (plan_valid_i && plan_i == plan_q)) &&
                   (!plan_valid_i || (plan_i.probes != '0 && 32'(plan_i.probes) <= feline_pkg::MaxProbes &&
                                      (is_gaussian || is_equal) &&
                                      !plan_i.status[feline_pkg::StatusUnsupported]));
endmodule

`default_nettype wire
