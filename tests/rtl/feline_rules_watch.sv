// SPDX-License-Identifier: Apache-2.0
// Counts the cycles in which a stage gets what the rules of its mutants (testbench/mutation/rules) say that it never
// gets. changed_i: the sampler state is another one, which is the driver's right between two batches.
`default_nettype none

module feline_rules_watch #(
  parameter string Stage = ""
) (
  input wire logic clk_i,
  input wire logic rst_i,
  input wire logic changed_i,
  input wire logic legal_i
);
  import "DPI-C" function void feline_rule_broken(input string stage);

  always_ff @(posedge clk_i) begin
    if (!rst_i && !changed_i && !legal_i) feline_rule_broken(Stage);
  end
endmodule

`default_nettype wire
