// SPDX-License-Identifier: Apache-2.0
// Which mutant a simulation runs: asked of the program once, when the unit is made.
`default_nettype none

module feline_mutation_source (
  output logic [63:0] mutant_o
);
  import "DPI-C" function longint unsigned feline_mutant();

  initial mutant_o = feline_mutant();
endmodule

`default_nettype wire
